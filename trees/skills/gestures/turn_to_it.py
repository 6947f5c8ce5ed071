"""Turn the feet to what was found beside the robot or behind it."""

from __future__ import annotations

from collections.abc import Sequence as Many

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.beliefs.grounding.destination import SLOTS
from trees.nodes.alternatives import Alternatives
from trees.policy import Gaze
from trees.skills.gestures.if_beside import IfBeside
from trees.skills.gestures.turn_to import TurnTo
from trees.skills.looking.search_place import search_place
from trees.skills.walking.ready_to_walk import ReadyToWalk
from trees.skills.walking.walk_with_room import change_viewpoint, narrower_arms_are_useless, with_room
from trees.toolbox import Toolbox

BESIDE_RAD = 1.0
"""Trunks turn by 1.2 rad, and hands reach farther: who waves or points up to here keeps the feet."""
BEHIND_RAD = 2.2
"""Trunk and head together look so far round."""


def turned_to(
    name: str,
    toolbox: Toolbox,
    gazes: Many[Gaze],
    beyond_rad: float = BESIDE_RAD,
    slots: Many[str] = SLOTS,
) -> Behaviour:
    """Turn to it where it is farther to a side than that, and see it again. Reads and writes "place"."""
    away: list[Behaviour] = [change_viewpoint(toolbox, "room"), _turn(toolbox)]
    ways: list[Behaviour] = [_turn(toolbox), Sequence("from a step away", memory=True, children=away)]
    turn: list[Behaviour] = [
        ReadyToWalk("stand upright", toolbox),
        Alternatives("face it", ways, narrower_arms_are_useless),
        search_place("see it again", toolbox, gazes, slots),
    ]
    return IfBeside(Sequence(name, memory=True, children=turn), toolbox, beyond_rad)


def _turn(toolbox: Toolbox) -> Behaviour:
    return with_room(toolbox, TurnTo("turn", toolbox), TurnTo("turn", toolbox))
