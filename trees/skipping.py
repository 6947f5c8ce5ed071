"""A decorator that skips its child where that is not needed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.decorators import Decorator
from py_trees.ports import PortsMixin


class Skipping(PortsMixin, Decorator):
    """Ticks its child while ``needed`` when it begins; otherwise succeeds at once.

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
