"""Know the room where somebody is said to be, from the map."""

from __future__ import annotations

from py_trees.common import Status

from trees.beliefs.grounding.destination import Place
from trees.beliefs.grounding.regions import place_of_region
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports
from trees.toolbox import Toolbox


class KnowRoom(Leaf):
    """Write a room of the map as a place to go to."""

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports(room=Place)
    CONTRACT = Contract("the map has the room", "its region was written", deadline_s=1.0)

    def __init__(self, name: str, toolbox: Toolbox, room: str) -> None:
        """Make the leaf.

        Args:
            name: Its name.
            toolbox: What it may call; knows the map.
            room: Name of a room of the map.
        """
        super().__init__(name, toolbox)
        self._room = room

    def step(self) -> Status:
        """Look it up."""
        self._set_output("room", place_of_region(self._room, self.toolbox.places[self._room]))
        return DONE
