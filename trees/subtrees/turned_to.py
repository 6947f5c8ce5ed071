"""Turn the feet to what was found beside the robot or behind it."""

from __future__ import annotations

from collections.abc import Sequence as Many

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.alternatives import Alternatives
from trees.if_beside import IfBeside
from trees.leaves.ready_to_walk import ReadyToWalk
from trees.leaves.turn_to import TurnTo
from trees.policy import Gaze
from trees.subtrees.look_elsewhere import change_viewpoint
from trees.subtrees.search_place import search_place
from trees.subtrees.with_room import narrower_arms_are_useless, with_room
from trees.toolbox import Toolbox

BESIDE_RAD = 1.0
"""Trunks turn by 1.2 rad, and hands reach farther: who waves or points up to here keeps the feet."""
BEHIND_RAD = 2.2
"""Trunk and head together look so far round."""


def turned_to(name: str, toolbox: Toolbox, gazes: Many[Gaze], beyond_rad: float = BESIDE_RAD) -> Behaviour:
    """Turn to it where it is farther to a side than that, and see it again. Reads and writes "place"."""
    away: list[Behaviour] = [change_viewpoint(toolbox, "room"), _turn(toolbox)]
    ways: list[Behaviour] = [_turn(toolbox), Sequence("from a step away", memory=True, children=away)]
    turn: list[Behaviour] = [
        ReadyToWalk("stand upright", toolbox),
        Alternatives("face it", ways, narrower_arms_are_useless),
        search_place("see it again", toolbox, gazes),
    ]
    return IfBeside(Sequence(name, memory=True, children=turn), toolbox, beyond_rad)


def _turn(toolbox: Toolbox) -> Behaviour:
    return with_room(toolbox, TurnTo("turn", toolbox), TurnTo("turn", toolbox))
