"""Put an object down: find room, plan, check, bring it there, lower it until it stands, let go, look.

Where this hand does not reach, it is put down on the way and taken up with the other one. A robot whose
fingers close on a palm, which has to hold it level, first walks to where the same hand reaches.
"""

from __future__ import annotations

from collections.abc import Callable

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.leaves.check_trajectory import CheckTrajectory
from trees.leaves.go_home import tidily
from trees.leaves.stream_motion import StreamMotion
from trees.nodes.alternatives import Alternatives
from trees.nodes.best_effort import BestEffort
from trees.nodes.judgements import no_other_attempt_helps
from trees.nodes.leaf import rewired
from trees.nodes.retry import Retry
from trees.nodes.skipping import IfShifted
from trees.skills.carrying.draw_back import DrawBack
from trees.skills.carrying.get_in_hand import get_in_hand
from trees.skills.carrying.let_go import LetGo
from trees.skills.carrying.look_at_placement import LookAtPlacement
from trees.skills.carrying.note_bystanders import NoteBystanders
from trees.skills.carrying.regrasp import regrasping
from trees.skills.carrying.still_held import StillHeld
from trees.skills.looking.hands_aside import HandsAside
from trees.skills.looking.look_over import look_over, look_past_hands
from trees.skills.place.find_spots import ExcludeSpot, FindSpots
from trees.skills.place.know_destination import know_destination
from trees.skills.place.lower import Lower, LowerFurther
from trees.skills.place.plan_place import PlanPlace
from trees.skills.place.raise_held import RaiseHeld
from trees.skills.place.see_held import SeeHeld
from trees.skills.place.settings import PlaceSettings
from trees.skills.place.stand_before_spot import before_the_spot
from trees.skills.place.swap_hands import other_hand_is_no_help, swap_hands
from trees.skills.place.verify_placed import VerifyPlaced
from trees.toolbox import Toolbox

# Steps farther down before a support is taken not to be there: 2 cm in all, beyond any perception error.
_FURTHER_STEPS = 3


def place(toolbox: Toolbox) -> Behaviour:
    """The whole skill. Reads "task" of the tree's namespace, writes "evidence"."""
    anywhere: list[Behaviour] = [rewired(_find_room(toolbox), {"task": "swap_place"}), _attempt(toolbox)]
    swapped: list[Behaviour] = [swap_hands(anywhere, toolbox), bring(toolbox)]
    ways: list[Behaviour] = [
        bring(toolbox),
        before_the_spot(bring(toolbox), toolbox),
        Sequence("other hand", memory=True, children=swapped),
    ]
    either = Alternatives("with either hand", ways, hopeless=other_hand_is_no_help)
    either.transparent = True
    carry: list[Behaviour] = [get_in_hand(toolbox, know_destination(toolbox)), either]
    children: list[Behaviour] = [
        look_over(toolbox),
        regrasping(carry, toolbox),
        BestEffort(DrawBack("draw back", toolbox)),
        HandsAside("clear the view", toolbox),
        look_over(toolbox),
        BestEffort(LookAtPlacement("look", toolbox)),
        VerifyPlaced("verify placed", toolbox, _seen_within_m(toolbox)),
    ]
    return tidily("place", children, toolbox)


def _seen_within_m(toolbox: Toolbox) -> float:
    """How near to its spot a thing is to be seen for it to be told as placed."""
    settings, grippers = toolbox.policy.of(PlaceSettings), toolbox.model.description.grippers
    pushes = any(gripper.palm_side_m is not None for gripper in grippers.values())
    return settings.placed_tolerance_m - (settings.seen_error_m if pushes else 0.0)


def over_the_spot(toolbox: Toolbox) -> list[Behaviour]:
    """Both ways checked, and the first one gone. Reads "transfer" and "lower", writes "checked_lower"."""
    return [
        CheckTrajectory("check transfer", toolbox, {"step": "transfer", "checked": "checked_transfer"}),
        CheckTrajectory("check lower", toolbox, {"step": "lower", "checked": "checked_lower"}),
        StreamMotion("transfer", toolbox, {"checked": "checked_transfer"}),
        StillHeld("still held", toolbox),
    ]


def set_down(toolbox: Toolbox, further_steps: int = _FURTHER_STEPS) -> list[Behaviour]:
    """Down until the object stands. Reads "checked_lower", writes "touched"."""
    further: list[Behaviour] = [
        LowerFurther(f"lower further {k}", toolbox, {"touched_now": "touched"})
        for k in range(1, further_steps + 1)
    ]
    return [
        Lower("lower", toolbox, {"checked": "checked_lower"}),
        *further,
    ]


class _Bring(Sequence):
    """Structures; it is left out of places in the tree."""

    transparent = True


def _find_room(toolbox: Toolbox) -> Behaviour:
    """Looks until a surface with room is seen."""
    return look_past_hands("find room", lambda: FindSpots("find spots", toolbox), toolbox)


def bring(toolbox: Toolbox, find_room: Callable[[Toolbox], Behaviour] = _find_room) -> Behaviour:
    """From a hand to a free spot. Reads "held", writes "placement" and "stood".

    Args:
        toolbox: What leaves may call.
        find_room: Makes what looks for room; it reads "held", and "task" if it needs it, and writes "spots".
    """
    recover = _recover(toolbox, find_room)
    attempts = Retry(
        "attempts", _attempt(toolbox), recover, toolbox.policy.place_attempts, no_other_attempt_helps
    )
    children: list[Behaviour] = [
        find_room(toolbox),
        NoteBystanders("note what stands about", toolbox),
        attempts,
    ]
    return _Bring("bring it", memory=True, children=children)


def _attempt(toolbox: Toolbox) -> Behaviour:
    again: list[Behaviour] = [PlanPlace("plan place", toolbox), *over_the_spot(toolbox)]
    children: list[Behaviour] = [
        PlanPlace("plan place", toolbox),
        *over_the_spot(toolbox),
        SeeHeld("see it in the hand", toolbox, {"held_now": "held"}),
        IfShifted(Sequence("over the spot again", memory=True, children=again)),
        *set_down(toolbox),
        StillHeld("held to the end", toolbox),
        LetGo("let go", toolbox),
    ]
    return Sequence("set down", memory=True, children=children)


def _recover(toolbox: Toolbox, find_room: Callable[[Toolbox], Behaviour]) -> Behaviour:
    children: list[Behaviour] = [
        StillHeld("not lost", toolbox),
        ExcludeSpot("exclude spot", toolbox, {"blocked_now": "blocked"}),
        BestEffort(RaiseHeld("lift it again", toolbox)),
        find_room(toolbox),
    ]
    return Sequence("try another spot", memory=True, children=children)
