"""Something that is needed only after failures of some kinds."""

from __future__ import annotations

from py_trees.behaviour import Behaviour

from trees.failures import Failure, FailureKind
from trees.ports import ports
from trees.skipping import Skipping


class OnlyAfter(Skipping):
    """Ticks its child when the failure at its port is of one of the kinds; otherwise succeeds at once.

    Attributes:
        kinds: The kinds.
    """

    INPUT_PORTS = ports(failure=Failure)
    OUTPUT_PORTS = ports()

    def __init__(self, child: Behaviour, kinds: frozenset[FailureKind]) -> None:
        super().__init__(f"{child.name} if it helps", child)
        self.kinds = kinds

    def needed(self) -> bool:
        """Whether the failure is of those kinds."""
        return self.get_input("failure").kind in self.kinds
