"""Walk to furniture, an object or a person."""

from __future__ import annotations

from collections.abc import Mapping

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.alternatives import Alternatives, defect
from trees.failures import Failure, FailureKind
from trees.leaves.change_viewpoint import ChangeViewpoint, Viewpoint
from trees.leaves.choose_furniture import ChooseFurniture
from trees.leaves.choose_outlook import ChooseOutlook
from trees.leaves.choose_stand import ChooseStand
from trees.leaves.know_place import KnowPlace
from trees.leaves.ready_to_walk import ReadyToWalk
from trees.leaves.recall_place import RecallPlace
from trees.leaves.see_front import SeeFront
from trees.leaves.squared_up import SquaredUp
from trees.leaves.walk_to import WalkTo
from trees.policy import Gaze
from trees.retry import Retry
from trees.subtrees.search import looking_elsewhere_is_useless
from trees.subtrees.search_place import everywhere, search_place
from trees.subtrees.tidily import tidily
from trees.subtrees.with_room import with_room
from trees.toolbox import Toolbox

_VIEWPOINTS: tuple[Viewpoint, ...] = ("around", "back", "around", "around", "ahead", "around", "ahead")
_SEEN_BEFORE, _FURNITURE, _OUTLOOKS = 5, 3, 2
"""Once the robot has turned around it goes to so much furniture that it saw, and beside so many tall things
that hide what is behind them, before it walks on at random."""
_NAMES = {"ahead": "go on", "around": "turn around", "back": "step back"}


def walk_to(toolbox: Toolbox) -> Behaviour:
    """Find it, walk there, look again, and correct. Reads "task", writes "evidence"."""
    steps = [find_place(toolbox), walks(toolbox, ChooseStand("choose where to stand", toolbox))]
    return tidily("walk to", steps, toolbox, toolbox.policy.walk_timeout_s)


def walks(toolbox: Toolbox, choose: Behaviour) -> Behaviour:
    """Walk to where one stands for a place that was seen, and correct. Reads "task" and "place".

    Args:
        toolbox: What leaves may call.
        choose: Writes "stand".
    """
    attempt = Sequence(
        "attempt",
        memory=True,
        children=[
            choose,
            ReadyToWalk("stand upright", toolbox),
            with_room(toolbox, WalkTo("walk", toolbox, if_hands_fit=True), WalkTo("walk", toolbox)),
            Alternatives(
                "find again",
                [
                    KnowPlace("know the place", toolbox),
                    SeeFront("see its front", toolbox, {"known": "place"}),
                    search_place("look again", toolbox, everywhere(toolbox)),
                ],
            ),
            SquaredUp("stand square", toolbox),
        ],
    )
    again = ReadyToWalk("stand upright", toolbox)
    return Retry("walks", attempt, again, toolbox.policy.walk_attempts, another_walk_is_useless)


def find_place(toolbox: Toolbox) -> Behaviour:
    """Look from here, then from elsewhere: the camera does not see all that one can walk to."""
    policy = toolbox.policy
    far = (*policy.search_gazes[:1], *policy.level_gazes)
    ways: list[Behaviour] = [
        KnowPlace("know the place", toolbox),
        search_place("look around", toolbox, (*far, *policy.search_gazes[1:2])),
    ]
    ways.append(RecallPlace("recall it", toolbox))
    for k, way in enumerate(_VIEWPOINTS, start=1):
        if k == _SEEN_BEFORE:
            ways += [_look_on_furniture(toolbox, one) for one in range(1, _FURNITURE + 1)]
            ways += [_look_behind(toolbox, one) for one in range(1, _OUTLOOKS + 1)]
        ways.append(
            Sequence(
                f"viewpoint {k}",
                memory=True,
                children=[
                    ReadyToWalk("stand upright", toolbox),
                    change_viewpoint(toolbox, way),
                    search_place("look around", toolbox, _level_first(far)),
                ],
            )
        )
    ways.append(RecallPlace("recall anything", toolbox, anything=True))
    return Alternatives("find it", ways, looking_elsewhere_is_useless, back_only_without_room)


def _look_on_furniture(toolbox: Toolbox, number: int) -> Behaviour:
    looks = [
        ChooseFurniture("choose furniture", toolbox, {"visited_before": "visited"}),
        *_going(toolbox, {"place": "furniture"}),
        search_place("look around", toolbox, everywhere(toolbox)),
    ]
    return Sequence(f"look on furniture {number}", memory=True, children=looks)


def _look_behind(toolbox: Toolbox, number: int) -> Behaviour:
    looks = [
        ChooseOutlook("choose outlook", toolbox, {"hiding_before": "hiding"}),
        *_going(toolbox, {"place": "hides", "stand": "outlook"}),
        search_place("look around", toolbox, toolbox.policy.level_gazes),
    ]
    return Sequence(f"look behind {number}", memory=True, children=looks)


def _going(toolbox: Toolbox, there: Mapping[str, str]) -> tuple[Behaviour, Behaviour]:
    """Stand upright, and walk where some names of the walk's ports say."""
    walk = WalkTo("walk", toolbox, if_hands_fit=True, wiring=there)
    return (
        ReadyToWalk("stand upright", toolbox),
        with_room(toolbox, walk, WalkTo("walk", toolbox, wiring=there)),
    )


def change_viewpoint(toolbox: Toolbox, way: Viewpoint) -> Behaviour:
    """Go on, step back, or turn, with the arms drawn in where they have no room to turn."""

    def leaf() -> Behaviour:
        return ChangeViewpoint(_NAMES[way], toolbox, way)

    return with_room(toolbox, leaf(), leaf()) if way == "around" else leaf()


def back_only_without_room(way: Behaviour, failure: Failure | None) -> bool:
    """A step back only after there was no room to turn; any other way always."""
    back = any(isinstance(leaf, ChangeViewpoint) and leaf.settings["way"] == "back" for leaf in way.children)
    return not back or (failure is not None and failure.root.kind is FailureKind.INFEASIBLE)


def _level_first(gazes: tuple[Gaze, ...]) -> tuple[Gaze, ...]:
    return (*gazes[1:], gazes[0])


def another_walk_is_useless(failure: Failure, before: Failure | None) -> bool:
    """Standing beside the place is put right by walking again; so is a way that was barred for a while."""
    twice = before is not None and before.kind is failure.kind is FailureKind.INFEASIBLE
    fine = failure.kind in (FailureKind.POSTCONDITION, FailureKind.INFEASIBLE)
    return defect(failure) or bool(failure.choices) or twice or not fine
