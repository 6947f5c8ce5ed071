"""Put an object into something: over its opening, as deep as the hand gets, let go, look.

A drawer has to be open: that is looked at before anything is picked up.
"""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.leaves.go_home import GoHome, tidily
from trees.nodes.alternatives import Alternatives
from trees.nodes.best_effort import BestEffort
from trees.nodes.judgements import no_other_attempt_helps
from trees.nodes.retry import Retry
from trees.policy import Gaze
from trees.skills.carrying.draw_back import DrawBack
from trees.skills.carrying.get_in_hand import get_in_hand
from trees.skills.carrying.let_go import LetGo
from trees.skills.carrying.look_at_placement import LookAtPlacement
from trees.skills.carrying.note_bystanders import NoteBystanders
from trees.skills.carrying.regrasp import regrasping
from trees.skills.carrying.still_held import StillHeld
from trees.skills.looking.look_at import LookAt
from trees.skills.looking.look_over import look_over, look_past_hands
from trees.skills.place.find_spots import ExcludeSpot
from trees.skills.place.know_destination import know_destination
from trees.skills.place.plan_place import PlanPlace
from trees.skills.place.raise_held import RaiseHeld
from trees.skills.place.tree import over_the_spot, set_down
from trees.skills.put_in.find_container import FindContainer
from trees.skills.put_in.not_shut import NotShut
from trees.skills.put_in.verify_put_in import VerifyPutIn
from trees.toolbox import Toolbox

_OVER_IT = Gaze("over it", tilt_rad=0.6, lean_rad=0.6)


def put_in(toolbox: Toolbox) -> Behaviour:
    """The whole skill. Reads "task" of the tree's namespace, writes "evidence"."""
    attempt: list[Behaviour] = [
        PlanPlace("plan put in", toolbox),
        *over_the_spot(toolbox),
        *set_down(toolbox, further_steps=0),
        StillHeld("held to the end", toolbox),
        LetGo("let go", toolbox, anyway=True),
    ]
    recover: list[Behaviour] = [
        StillHeld("not lost", toolbox),
        ExcludeSpot("exclude spot", toolbox, {"blocked_now": "blocked"}),
        BestEffort(RaiseHeld("lift it again", toolbox)),
        _find_container(toolbox),
    ]
    attempts = Retry(
        "attempts",
        Sequence("lower it in", memory=True, children=attempt),
        Sequence("try otherwise", memory=True, children=recover),
        toolbox.policy.place_attempts,
        no_other_attempt_helps,
    )
    carry: list[Behaviour] = [
        get_in_hand(toolbox, know_destination(toolbox)),
        _find_container(toolbox),
        NoteBystanders("note what stands about", toolbox),
        attempts,
    ]
    children: list[Behaviour] = [
        NotShut("is it open", toolbox),
        look_over(toolbox),
        NotShut("is it open after all", toolbox),
        regrasping(carry, toolbox),
        BestEffort(DrawBack("draw back", toolbox)),
        GoHome("clear the view", toolbox),
        look_over(toolbox),
        _see_it_inside(toolbox),
    ]
    return tidily("put in", children, toolbox)


def _see_it_inside(toolbox: Toolbox) -> Behaviour:
    """From home, and where a wall hides it, from above."""
    from_home: list[Behaviour] = [
        BestEffort(LookAtPlacement("look into it", toolbox)),
        VerifyPutIn("verify put in", toolbox),
    ]
    from_above: list[Behaviour] = [
        LookAt("lean over it", toolbox, _OVER_IT),
        VerifyPutIn("verify from above", toolbox),
        GoHome("straighten up", toolbox),
    ]
    ways: list[Behaviour] = [
        Sequence("look from home", memory=True, children=from_home),
        Sequence("look from above", memory=True, children=from_above),
    ]
    return Alternatives("see it inside", ways)


def _find_container(toolbox: Toolbox) -> Behaviour:
    """Looks until it is seen; what the held thing hides from every side is where it was."""
    name = "find what it goes into"
    looks = look_past_hands(name, lambda: FindContainer("find container", toolbox), toolbox)
    looks.add_child(FindContainer("where it was", toolbox, remembered=True))
    return looks
