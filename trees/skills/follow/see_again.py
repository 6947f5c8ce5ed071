"""See the person again who was lost."""

from __future__ import annotations

from collections.abc import Mapping

from py_trees.common import Status

from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.grounding.destination import Place, place_from
from trees.failures import Failure, Reason
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.skills.looking.look_around import LookAround


class SeeAgain(LookAround):
    """Look once for the person whom the robot had in view before; somebody else does not do."""

    ASKS = True
    INPUT_PORTS = ports(known=Place)
    OUTPUT_PORTS = ports(place=Place)
    CONTRACT = Contract(
        precondition="the head is at rest",
        postcondition="the person was seen just now; everything seen is in the world model",
        deadline_s=2.0,
    )

    def found(self, seen: Mapping[str, ObjectEstimate]) -> Status | Failure:
        """Take the sighting of the same person."""
        name = self.get_input("known").name
        item = seen.get(name)
        if item is None or item.category != "person":
            return Failure.postcondition(f"{name} is not in view").because(Reason.PERSON_LOST)
        self._set_output("place", place_from(name, item))
        return DONE
