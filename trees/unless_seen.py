"""Something that is done only when the way of the planned motion was not looked at yet."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.decorators import Decorator
from py_trees.ports import PortsMixin

from kinematics.requests import Grasp
from trees.hand_ways import unseen_on_way
from trees.ports import ports
from trees.steps import Step, Target
from trees.toolbox import Toolbox


class UnlessSeen(PortsMixin, Decorator):
    """Ticks its child when a hand is to go where nobody has looked; otherwise succeeds at once."""

    INPUT_PORTS = ports(target=Target, grasp=Grasp, reach=Step)
    OUTPUT_PORTS = ports()
    transparent = True

    def __init__(self, child: Behaviour, toolbox: Toolbox) -> None:
        super().__init__(name=f"{child.name} unless seen", child=child)
        self.wiring: Mapping[str, str] = {}
        self._toolbox = toolbox

    def wire(self, namespace: str) -> None:
        """Connect the ports inside a tree's namespace."""
        self.setup_ports({port: self.wiring.get(port, port) for port in self.INPUT_PORTS}, namespace)

    def tick(self) -> Iterator[Behaviour]:
        """Skip the child, or tick it."""
        if self.status is Status.RUNNING or self._needed():
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

    def _needed(self) -> bool:
        target, hand = self.get_input("target"), self.get_input("grasp").hand
        return len(unseen_on_way(self._toolbox, target, self.get_input("reach"), hand)) > 0
