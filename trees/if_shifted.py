"""Something that is done only when what a hand carries has shifted in it."""

from __future__ import annotations

from py_trees.behaviour import Behaviour

from trees.ports import ports
from trees.skipping import Skipping


class IfShifted(Skipping):
    """Ticks its child when what is carried has shifted; otherwise succeeds at once."""

    INPUT_PORTS = ports(shifted=bool)
    OUTPUT_PORTS = ports()

    def __init__(self, child: Behaviour) -> None:
        super().__init__(f"{child.name} if it has shifted", child)

    def needed(self) -> bool:
        """Whether what was planned is for another pose in the hand."""
        return bool(self.get_input("shifted"))
