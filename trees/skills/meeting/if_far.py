"""Something that is done only when somebody is too far away to be spoken to."""

from __future__ import annotations

from py_trees.behaviour import Behaviour

from trees.beliefs.grounding.destination import Place
from trees.nodes.ports import ports
from trees.nodes.skipping import Skipping
from trees.readings.odometry import away_m
from trees.skills.meeting.settings import MeetingSettings
from trees.toolbox import Toolbox


class IfFar(Skipping):
    """Ticks its child if the person at the place is far away, and the robot can walk; else it succeeds."""

    INPUT_PORTS = ports(place=Place)
    OUTPUT_PORTS = ports()

    def __init__(self, child: Behaviour, toolbox: Toolbox) -> None:
        super().__init__(f"{child.name} if far", child)
        self._toolbox = toolbox

    def needed(self) -> bool:
        """Whether the robot has to go there, and can."""
        far_m = away_m(self._toolbox, self.get_input("place"))
        return self._toolbox.can_walk and far_m > self._toolbox.policy.of(MeetingSettings).near_m
