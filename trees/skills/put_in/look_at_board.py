"""Turn the eyes to a board behind an open door."""

from __future__ import annotations

from collections.abc import Mapping

from kinematics.requests.move import MoveRequest
from trees.beliefs.openings.fridge_inside import FridgeInside, front_of, inside_of_fridge
from trees.failures import Failure
from trees.nodes.ports import ports
from trees.skills.looking.aiming_leaf import AimingLeaf
from trees.skills.looking.look_at import joints_that_show
from trees.toolbox import Toolbox

_BEHIND_EDGE_M = 0.10
"""Where things are put on a board."""


class LookAtBoard(AimingLeaf):
    """Turn the eyes so that the front of a board behind an open door is in the middle of the picture.

    Args:
        name: Of the node.
        toolbox: What it may call.
        rank: Which board, the one of the most comfortable height first.
    """

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()

    def __init__(self, name: str, toolbox: Toolbox, rank: int = 0) -> None:
        super().__init__(name, toolbox)
        self._rank = rank

    def goal(self) -> MoveRequest | Failure | None:
        """A motion of the eyes, if there is such a board."""
        inside = inside_of_fridge(self.toolbox.world.scene)
        if isinstance(inside, Failure):
            return inside
        if self._rank >= len(inside.boards):
            return Failure.postcondition("no other board was seen", boards=len(inside.boards))
        self._inside: FridgeInside = inside
        return super().goal()

    def joints(self) -> Mapping[str, float]:
        """The goal of the head's joints, and of the trunk's if need be, rad."""
        edge = front_of(self._inside.boards[self._rank])
        return joints_that_show(self.toolbox, (edge @ [_BEHIND_EDGE_M, 0.0, 0.0, 1.0])[:3])
