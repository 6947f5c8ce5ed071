"""The base of leaves that close fingers on something fixed while the arm gives way."""

from __future__ import annotations

from abc import abstractmethod

from py_trees.common import Status

from kinematics.requests.grasp import Grasp
from robots.control.hands.yield_order import YieldOrder
from robots.control.motion_handle import MotionHandle, MotionStatus
from trees.failures import Failure
from trees.nodes.leaf import RUNNING
from trees.nodes.motion_leaf import motion_failure
from trees.nodes.yielding_leaf import YieldingLeaf

_QUIET_S = 0.25
"""Before the fingers move, the hand feels what counts as no force."""


class ClosingLeaf(YieldingLeaf):
    """Close the gripper on what stays where it is: fingers that meet it off centre move the hand with them.

    Reads the port "grasp". Ends when the fingers have come to rest; ``finish`` judges what they hold.
    """

    _fingers: MotionHandle | None = None

    @abstractmethod
    def order(self, grasp: Grasp) -> YieldOrder:
        """How the arm gives way, and what the hand may touch."""

    def begin(self) -> None:
        """Forget an earlier run."""
        super().begin()
        self._fingers = None

    def start(self) -> MotionHandle | Failure:
        """Let the arm yield."""
        return self.lead(self.order(self.get_input("grasp")))

    def step(self) -> Status | Failure:
        """Yield, close, settle, judge."""
        outcome = super().step()
        if outcome is not RUNNING:
            return outcome
        if self._fingers is None:
            if self.elapsed_s >= _QUIET_S:
                grasp: Grasp = self.get_input("grasp")
                self._fingers = self.toolbox.grippers[grasp.hand].close()
            return RUNNING
        if (ended := motion_failure(self._fingers)) is not None:
            return ended
        if self._fingers.status is not MotionStatus.RUNNING:
            self.led.finish()
        return RUNNING

    def release(self, reason: str) -> None:
        """Hold."""
        if self._fingers is not None and not self._fingers.finished:
            self.toolbox.motion.cancel(self._fingers, reason)
        super().release(reason)
