"""What a guide says to whom it leads."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from py_trees.common import Status

from trees.beliefs.grounding.destination import Place, called
from trees.events import Said
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports
from trees.toolbox import Toolbox

_WORDS = {"invite": "Please follow me to {there}.", "arrive": "Here we are: {there}."}


class SpeakToGuest(Leaf):
    """Say to the person who is led what comes now."""

    INPUT_PORTS = ports(task=object, place=Place)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract("the person was seen", "the words were given out", deadline_s=1.0)

    def __init__(
        self,
        name: str,
        toolbox: Toolbox,
        words: Literal["invite", "arrive"],
        wiring: Mapping[str, str] | None = None,
    ) -> None:
        """Make the leaf.

        Args:
            name: Its name.
            toolbox: What it may call.
            words: Whether it asks the person to come, or tells that both have arrived.
            wiring: Other names of its ports.
        """
        super().__init__(name, toolbox, wiring)
        self._words = words

    def step(self) -> Status | Failure:
        """Give the words out."""
        person: Place = self.get_input("place")
        to = getattr(self.get_input("task"), "to", None)
        text = _WORDS[self._words].format(there=called(to))
        self.toolbox.events(Said(self.toolbox.clock.now_s(), text, person.name))
        self.feedback_message = text
        return DONE
