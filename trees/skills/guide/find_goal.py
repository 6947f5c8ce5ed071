"""Find out where somebody is to be led."""

from __future__ import annotations

from collections.abc import Mapping

from py_trees.common import Status

from robots.perception.detector import Category
from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.grounding.destination import (
    START,
    Place,
    furniture_named,
    place_of_region,
    start,
    words_of,
)
from trees.failures import Failure, Reason
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.skills.looking.look_around import LookAround
from trees.tasks import Destination, ObjectDescription


class FindGoal(LookAround):
    """Know the place that somebody is to be led to: from the map, from what is believed, or by a look."""

    ASKS = True
    LOOKING_ON = True
    INPUT_PORTS = ports(task=object)
    OUTPUT_PORTS = ports(destination=Place)
    CONTRACT = Contract(
        precondition="the head is at rest",
        postcondition="the place is on the map, or is furniture or a person that was seen",
        deadline_s=2.0,
    )

    def step(self) -> Status | Failure:
        """Look only where it is not known."""
        return DONE if self._is_known() else super().step()

    def found(self, seen: Mapping[str, ObjectEstimate]) -> Status | Failure:
        """Take it from what is seen now."""
        del seen
        if self._is_known():
            return DONE
        to = self._to
        known = ", ".join(sorted(self.toolbox.places)) or "no room"
        message = f"I do not know where the {words_of(to)} is; the map has {known}"
        return Failure.postcondition(message, known=known).because(Reason.NOT_SEEN)

    @property
    def _to(self) -> Destination | None:
        to: Destination | None = getattr(self.get_input("task"), "to", None)
        return to

    def _is_known(self) -> bool:
        to, places, scene = self._to, self.toolbox.places, self.toolbox.world.scene
        word = (to.name or to.kind or "") if isinstance(to, ObjectDescription) else str(to)
        if word in places:
            self._set_output("destination", place_of_region(word, places[word]))
            return True
        if word == START:
            self._set_output("destination", start())
            return True
        named = [item for item in scene.objects.values() if item.name.casefold() == word.casefold()]
        found = named or furniture_named(word, scene)
        if not found:
            return False
        item = found[0]
        category: Category = "person" if item.name[:1].isupper() else "furniture"
        self._set_output("destination", Place(item.name, category, item.shape, item.world_T_object, 1.0))
        return True
