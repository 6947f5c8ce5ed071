"""See that somebody who was waved to is still where the wave went."""

from __future__ import annotations

import math
from collections.abc import Mapping

from py_trees.common import Status

from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.grounding.destination import Place, place_from
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.readings.odometry import bearing_rad
from trees.skills.looking.look_around import LookAround

_ASIDE_RAD = math.radians(12.0)
"""So much of the 20 degrees within which somebody is faced a walk may take."""


class StillThere(LookAround):
    """Look once more; who has walked aside meanwhile, or out of view, was not waved to."""

    INPUT_PORTS = ports(place=Place)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the person was seen before the wave",
        postcondition="the person is in the direction that was faced",
        deadline_s=2.0,
    )

    LOOKING_ON = True

    def found(self, seen: Mapping[str, ObjectEstimate]) -> Status | Failure:
        """Compare the directions."""
        place: Place = self.get_input("place")
        if place.name not in seen:
            return Failure.postcondition(f"{place.name} has walked out of view")
        now = place_from(place.name, seen[place.name])
        turn = bearing_rad(self.toolbox, now) - bearing_rad(self.toolbox, place)
        aside_rad = abs(math.remainder(turn, 2.0 * math.pi))
        self.measured(aside_rad=aside_rad)
        if aside_rad > _ASIDE_RAD:
            return Failure.postcondition(f"{place.name} has walked on", aside_rad=aside_rad)
        return DONE
