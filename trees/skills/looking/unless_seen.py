"""Something that is done only when the way of a hand was not looked at yet."""

from __future__ import annotations

from py_trees.behaviour import Behaviour

from trees.nodes.ports import ports
from trees.nodes.skipping import Skipping
from trees.skills.looking.hand_ways import UnseenPlaces


class UnlessSeen(Skipping):
    """Ticks its child if a hand is to pass over places that no look has shown; otherwise succeeds at once."""

    INPUT_PORTS = ports(unseen=UnseenPlaces)
    OUTPUT_PORTS = ports()

    def __init__(self, child: Behaviour) -> None:
        super().__init__(f"{child.name} unless seen", child)

    def needed(self) -> bool:
        """Whether there is such a place."""
        return len(self.get_input("unseen").points) > 0
