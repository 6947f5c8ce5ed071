"""Something that is needed only after failures of some kinds."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.decorators import Decorator
from py_trees.ports import PortsMixin

from trees.failures import Failure, FailureKind
from trees.ports import ports


class OnlyAfter(PortsMixin, Decorator):
    """Ticks its child when the failure at its port is of one of the kinds; otherwise succeeds at once.

    Attributes:
        kinds: The kinds.
    """

    INPUT_PORTS = ports(failure=Failure)
    OUTPUT_PORTS = ports()
    transparent = True

    def __init__(self, child: Behaviour, kinds: frozenset[FailureKind]) -> None:
        super().__init__(name=f"{child.name} if it helps", child=child)
        self.wiring: Mapping[str, str] = {}
        self.kinds = kinds

    def wire(self, namespace: str) -> None:
        """Connect the ports inside a tree's namespace."""
        self.setup_ports({"failure": self.wiring.get("failure", "failure")}, namespace)

    def tick(self) -> Iterator[Behaviour]:
        """Skip the child, or tick it."""
        if self.status is Status.RUNNING or self.get_input("failure").kind in self.kinds:
            yield from super().tick()
            return
        self.stop(Status.INVALID)
        self.feedback_message = "not needed"
        self.stop(Status.SUCCESS)
        yield self

    def update(self) -> Status:
        """The child's status."""
        self.feedback_message = ""
        return self.decorated.status
