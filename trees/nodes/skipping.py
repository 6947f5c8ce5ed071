"""A decorator that skips its child where that is not needed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.decorators import Decorator

from trees.failures import Failure, FailureKind
from trees.nodes.ports import WithPorts, ports


class Skipping(WithPorts, Decorator):
    """Ticks its child if ``needed`` says so when it begins; otherwise it succeeds at once.

    A subclass declares ``INPUT_PORTS`` and ``OUTPUT_PORTS``, and fills in ``needed``.
    """

    transparent = True

    def __init__(self, name: str, child: Behaviour) -> None:
        super().__init__(name=name, child=child)
        self.wiring: Mapping[str, str] = {}

    def needed(self) -> bool:
        """Whether the child is to be ticked; asked before each beginning."""
        raise NotImplementedError

    def wire(self, namespace: str) -> None:
        """Connect the ports inside a tree's namespace."""
        self.setup_ports({port: self.wiring.get(port, port) for port in self.INPUT_PORTS}, namespace)

    def tick(self) -> Iterator[Behaviour]:
        """Skip the child, or tick it."""
        if self.status is Status.RUNNING or self.needed():
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


class OnlyAfter(Skipping):
    """Ticks its child only after a failure of certain kinds, read from a port; otherwise succeeds at once.

    Attributes:
        kinds: The kinds of failure after which the child is ticked.
    """

    INPUT_PORTS = ports(failure=Failure)
    OUTPUT_PORTS = ports()

    def __init__(self, child: Behaviour, kinds: frozenset[FailureKind]) -> None:
        super().__init__(f"{child.name} if it helps", child)
        self.kinds = kinds

    def needed(self) -> bool:
        """Whether the failure is of those kinds."""
        return self.get_input("failure").kind in self.kinds


class UnlessHeld(Skipping):
    """Ticks its child if no hand holds the object that the task means; otherwise succeeds at once."""

    INPUT_PORTS = ports(in_hand=bool)
    OUTPUT_PORTS = ports()

    def __init__(self, child: Behaviour) -> None:
        super().__init__(f"{child.name} unless held", child)

    def needed(self) -> bool:
        """Whether it has to be picked up."""
        return not self.get_input("in_hand")


class IfShifted(Skipping):
    """Ticks its child if the object in the hand has shifted there, so that plans are void; else succeeds."""

    INPUT_PORTS = ports(shifted=bool)
    OUTPUT_PORTS = ports()

    def __init__(self, child: Behaviour) -> None:
        super().__init__(f"{child.name} if it has shifted", child)

    def needed(self) -> bool:
        """Whether what was planned is for another pose in the hand."""
        return bool(self.get_input("shifted"))
