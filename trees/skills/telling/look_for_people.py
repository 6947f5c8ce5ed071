"""Look, and remember who was seen where."""

from __future__ import annotations

from collections.abc import Mapping

from py_trees.common import Status

from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.grounding.destination import Place, place_from
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import optional, ports
from trees.skills.looking.look_around import LookAround


class LookForPeople(LookAround):
    """Take one more look, and add the people in it to those whom earlier looks have shown."""

    INPUT_PORTS = ports(people_before=optional(dict))
    OUTPUT_PORTS = ports(people=dict)
    CONTRACT = Contract(
        precondition="the head is at rest",
        postcondition="everything in view is in the world model; everybody in view is noted",
        deadline_s=2.0,
    )

    LOOKING_ON = True

    def found(self, seen: Mapping[str, ObjectEstimate]) -> Status | Failure:
        """Keep the newest sighting of each."""
        people: dict[str, Place] = dict(self.optional("people_before") or {})
        people |= {name: place_from(name, item) for name, item in seen.items() if item.category == "person"}
        self._set_output("people", people)
        self.feedback_message = ", ".join(sorted(people)) or "nobody"
        return DONE
