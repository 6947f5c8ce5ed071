"""Look, and note with what confidence each thing was seen."""

from __future__ import annotations

from collections.abc import Mapping

from py_trees.common import Status
from py_trees.ports import PortInformation

from robots.perception.object_estimate import ObjectEstimate
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, RUNNING
from trees.nodes.ports import ports
from trees.skills.looking.look_around import LookAround
from trees.toolbox import Toolbox

_MOST_LOOKS = 5
"""At somebody of whom nothing is told: a light, or a face turned away, does not get better."""


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
        self,
        name: str,
        toolbox: Toolbox,
        wiring: Mapping[str, str] | None = None,
        *,
        keeping: bool = False,
        traits: bool = False,
    ) -> None:
        """Make the leaf.

        Args:
            name: Its name.
            toolbox: What it may call.
            wiring: As for every leaf.
            keeping: As for ``LookAround``.
            traits: Whether it is asked how people are: who is in view is looked at again until hardly more
                can be told of them.
        """
        super().__init__(name, toolbox, wiring)
        self.keeping = keeping
        self._traits = traits

    def begin(self) -> None:
        """No look yet."""
        super().begin()
        self._looks = 0

    def found(self, seen: Mapping[str, ObjectEstimate]) -> Status | Failure:
        """Keep the best confidence of each name."""
        noted: dict[str, float] = dict(self.get_input("sightings"))
        for name, item in seen.items():
            noted[name] = max(noted.get(name, 0.0), item.confidence)
        self._set_output("sightings_now", noted)
        self._looks += 1
        if self._traits and self._looks < _MOST_LOOKS and self._tells_too_little(seen):
            self._views = []
            return RUNNING
        self.feedback_message = f"{len(seen)} things in view"
        return DONE

    def _tells_too_little(self, seen: Mapping[str, ObjectEstimate]) -> bool:
        people = self.toolbox.world.people
        return any(item.category == "person" and not people[name].enough for name, item in seen.items())

    @property
    def deadline_s(self) -> float:
        """The policy's time for as many looks as it may take."""
        return self.toolbox.policy.look_timeout_s * (_MOST_LOOKS if self._traits else 1)
