"""Something that is done only while the robot is not in the room where somebody is said to be."""

from __future__ import annotations

from py_trees.behaviour import Behaviour

from robots.scenes.scene_description import Region
from trees.nodes.ports import ports
from trees.nodes.skipping import Skipping
from trees.readings.odometry import body_pose
from trees.toolbox import Toolbox


class IfOutside(Skipping):
    """Ticks its child if the robot does not stand in a room of the map; else it succeeds.

    Attributes:
        region: The room.
    """

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()

    def __init__(self, child: Behaviour, toolbox: Toolbox, region: Region) -> None:
        super().__init__(f"{child.name} if outside", child)
        self._toolbox, self.region = toolbox, region

    def needed(self) -> bool:
        """Whether the robot has to go there."""
        body = body_pose(self._toolbox)
        return not self.region.contains(body.x_m, body.y_m)
