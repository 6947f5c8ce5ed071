"""Something that is done only when what a task is aimed at is too far to a side for the trunk."""

from __future__ import annotations

from py_trees.behaviour import Behaviour

from trees.beliefs.grounding.destination import Place
from trees.nodes.ports import ports
from trees.nodes.skipping import Skipping
from trees.readings.odometry import bearing_rad
from trees.toolbox import Toolbox


class IfBeside(Skipping):
    """Ticks its child if the robot has to turn its feet to face the place, and can; else it succeeds.

    Attributes:
        beyond_rad: Angle between where the feet point and the place from which on they have to turn.
    """

    INPUT_PORTS = ports(place=Place)
    OUTPUT_PORTS = ports()

    def __init__(self, child: Behaviour, toolbox: Toolbox, beyond_rad: float) -> None:
        super().__init__(f"{child.name} if beside", child)
        self._toolbox = toolbox
        self.beyond_rad = beyond_rad

    def needed(self) -> bool:
        """Whether the feet have to turn, and can."""
        aside_rad = abs(bearing_rad(self._toolbox, self.get_input("place")))
        return self._toolbox.can_walk and aside_rad > self.beyond_rad
