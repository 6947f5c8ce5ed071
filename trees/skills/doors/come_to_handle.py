"""Stand where a handle can be led all its way."""

from __future__ import annotations

from collections.abc import Callable

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.failures import Failure
from trees.nodes.alternatives import Alternatives
from trees.nodes.best_effort import BestEffort
from trees.nodes.judgements import defect, judgement
from trees.nodes.retry import Retry
from trees.skills.doors.choose_stand_at_handle import ChooseStandAtHandle, WalkToStandAtHandle
from trees.skills.doors.handle_standing import WalkToHandle
from trees.skills.doors.stands_at_handle import StandsAtHandle, StandsThereAlready
from trees.skills.walk_to.tree import another_walk_is_useless
from trees.skills.walking.ready_to_walk import ReadyToWalk
from trees.skills.walking.walk_with_room import with_room
from trees.toolbox import Toolbox

_WALKS = 3


def come_to_handle(toolbox: Toolbox, look: Callable[[str], Behaviour]) -> Behaviour:
    """Nothing where the robot stands well; else walk there, look again, and correct.

    Where nobody can stand square before it, any place does from which a hand can lead it all its way.

    Args:
        toolbox: What leaves may call.
        look: Makes what sees the handle anew; reads "task", writes "handle".
    """
    walk = WalkToHandle("walk", toolbox, if_hands_fit=True)
    attempt = Sequence(
        "walk there",
        memory=True,
        children=[
            ReadyToWalk("stand upright", toolbox),
            with_room(toolbox, walk, WalkToHandle("walk", toolbox)),
            look("look again"),
            StandsAtHandle("stand well", toolbox),
        ],
    )
    again = ReadyToWalk("stand upright", toolbox)
    walks = Retry("walks", attempt, again, _WALKS, another_walk_is_useless)
    return Alternatives(
        "come to it",
        [StandsThereAlready("stand well already", toolbox), walks, stand_aside(toolbox, look)],
        hopeless=defect,
        worth_trying=is_known_by_a_model,
    )


@judgement
def is_known_by_a_model(way: Behaviour, _failure: Failure | None) -> bool:
    """Standing aside only for what is known by a model, and by who can walk; any other way always."""
    leaves = [leaf for leaf in way.iterate() if isinstance(leaf, ChooseStandAtHandle)]
    return not leaves or leaves[0].may_help


def stand_aside(toolbox: Toolbox, look: Callable[[str], Behaviour]) -> Behaviour:
    """Stand where the planner has a way for the hand, here or elsewhere; where it is seen from, look again.

    Args:
        toolbox: What leaves may call.
        look: Makes what sees the handle anew; reads "task", writes "handle".
    """
    walk = WalkToStandAtHandle("walk", toolbox, if_hands_fit=True)
    return Sequence(
        "stand aside",
        memory=True,
        children=[
            ChooseStandAtHandle("choose where to stand", toolbox),
            ReadyToWalk("stand upright", toolbox),
            with_room(toolbox, walk, WalkToStandAtHandle("walk", toolbox)),
            BestEffort(look("look from aside")),
        ],
    )
