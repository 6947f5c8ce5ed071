"""Something that is done only while the robot is not in the room where somebody is said to be."""

from __future__ import annotations

from py_trees.behaviour import Behaviour

from trees.nodes.ports import ports
from trees.nodes.skipping import Skipping
from trees.readings.odometry import body_pose
from trees.toolbox import Toolbox


class IfOutside(Skipping):
    """Ticks its child if the robot does not stand in a room of the map; else it succeeds.

    Attributes:
        room: Its name; one that is not on the map is not gone to.
    """

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()

    def __init__(self, child: Behaviour, toolbox: Toolbox, room: str) -> None:
        super().__init__(f"{child.name} if outside", child)
        self._toolbox, self.room = toolbox, room

    def needed(self) -> bool:
        """Whether the robot has to go there."""
        body, region = body_pose(self._toolbox), self._toolbox.places.get(self.room)
        return region is not None and not region.contains(body.x_m, body.y_m)
