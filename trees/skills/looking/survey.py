"""Look, and note with what confidence each thing was seen."""

from __future__ import annotations

from collections.abc import Mapping

from py_trees.common import Status
from py_trees.ports import PortInformation

from robots.perception.object_estimate import ObjectEstimate
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.skills.looking.look_around import LookAround
from trees.toolbox import Toolbox


class Survey(LookAround):
    """Take one more look, update the world model, and note how sure the detector is of each thing."""

    INPUT_PORTS = ports(sightings=PortInformation(dict, default_value={}))
    OUTPUT_PORTS = ports(sightings_now=dict)
    CONTRACT = Contract(
        precondition="the head is at rest",
        postcondition="everything in view is in the world model, with the best confidence of all looks",
        deadline_s=2.0,
    )

    LOOKING_ON = True

    def __init__(
        self, name: str, toolbox: Toolbox, wiring: Mapping[str, str] | None = None, *, keeping: bool = False
    ) -> None:
        super().__init__(name, toolbox, wiring)
        self.keeping = keeping

    def found(self, seen: Mapping[str, ObjectEstimate]) -> Status | Failure:
        """Keep the best confidence of each name."""
        noted: dict[str, float] = dict(self.get_input("sightings"))
        for name, item in seen.items():
            noted[name] = max(noted.get(name, 0.0), item.confidence)
        self._set_output("sightings_now", noted)
        self.feedback_message = f"{len(seen)} things in view"
        return DONE
