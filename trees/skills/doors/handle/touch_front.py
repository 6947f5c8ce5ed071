"""From a hand that has come to a front to one that can push it."""

from __future__ import annotations

from py_trees.common import Status

from kinematics.requests.grasp import Grasp
from robots.control.hands.yield_settings import YieldReport
from trees.beliefs.openings.handles import HandleTarget
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import optional, ports
from trees.skills.doors.handle.held_handle import HeldHandle, tcp_m


class TouchFront(Leaf):
    """Write the path about the hinge that a hand at the front of a door will follow when it pushes it."""

    INPUT_PORTS = ports(handle=HandleTarget, grasp=Grasp, approached=optional(YieldReport))
    OUTPUT_PORTS = ports(held=HeldHandle)
    CONTRACT = Contract(
        precondition="the hand is at the front, or close before it",
        postcondition="the way of the hand about the hinge is known",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Lay the arc through the hand."""
        target: HandleTarget = self.get_input("handle")
        grasp: Grasp = self.get_input("grasp")
        place = tcp_m(self.toolbox, grasp, self.toolbox.motion.reference())
        path = target.path.through(place, target.opening)
        approached: YieldReport | None = self.optional("approached")
        bias = None if approached is None else approached.bias  # of before the hand met the front
        self._set_output("held", HeldHandle(target, grasp, path, bias))
        return DONE
