"""Something that is done only when what is meant is in no hand yet."""

from __future__ import annotations

from py_trees.behaviour import Behaviour

from trees.ports import ports
from trees.skipping import Skipping


class UnlessHeld(Skipping):
    """Ticks its child when what is meant is in no hand; otherwise succeeds at once."""

    INPUT_PORTS = ports(in_hand=bool)
    OUTPUT_PORTS = ports()

    def __init__(self, child: Behaviour) -> None:
        super().__init__(f"{child.name} unless held", child)

    def needed(self) -> bool:
        """Whether it has to be picked up."""
        return not self.get_input("in_hand")
