"""See whether the robot stands near somebody."""

from __future__ import annotations

from py_trees.common import Status

from trees.beliefs.grounding.destination import Place
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports
from trees.readings.odometry import away_m
from trees.skills.meeting.settings import MeetingSettings


class IsNear(Leaf):
    """Compare how far away somebody was seen with how far people are spoken to."""

    INPUT_PORTS = ports(place=Place)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the person was seen from where the robot stands",
        postcondition="the person is near enough to be spoken to",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Measure once."""
        place: Place = self.get_input("place")
        far_m, near_m = away_m(self.toolbox, place), self.toolbox.policy.of(MeetingSettings).near_m
        self.measured(away_m=far_m)
        if far_m > near_m:
            return Failure.postcondition(f"{place.name} has walked on", away_m=far_m, near_m=near_m)
        return DONE
