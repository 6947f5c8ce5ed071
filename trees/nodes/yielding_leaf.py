"""A leaf whose hand yields to what it holds or meets."""

from __future__ import annotations

from py_trees.common import Status

from robots.control.hands.yield_order import YieldOrder
from robots.control.motion_handle import MotionHandle, MotionStatus
from trees.failures import Failure
from trees.nodes.leaf import RUNNING
from trees.nodes.motion_leaf import MotionLeaf
from trees.toolbox import YieldingMotion

_STOPPED_S = 0.6
"""A stop that the online checker begins has come to rest by then; before, no finger may move."""


class YieldingLeaf(MotionLeaf):
    """A leaf whose hand moves along a path and gives way to what it holds or meets.

    It starts the motion, follows it, and cancels it when the leaf ends early. When the online checker refuses
    the motion on its way, the leaf waits until the robot has come to rest before it fails: the recovery that
    follows begins by moving fingers, which must not happen during the stop.
    """

    _yielding: YieldingMotion | None = None
    _refused_s: float | None = None

    def begin(self) -> None:
        """Forget the motion of an earlier run."""
        super().begin()
        self._yielding, self._refused_s = None, None

    def step(self) -> Status | Failure:
        """Follow the hand; after a refusal on the way wait for the stop."""
        if self._refused_s is None:
            result = super().step()
            refused = self._handle is not None and self._handle.status is MotionStatus.REFUSED
            if not refused or self._handle is None or self._handle.progress == 0.0:
                return result
            self._refused_s = self.elapsed_s
        self.feedback_message = "waiting for the stop to end"
        return RUNNING if self.elapsed_s < self._refused_s + _STOPPED_S else super().step()

    def lead(self, order: YieldOrder) -> MotionHandle | Failure:
        """Begin; what is felt is in ``led`` from then on."""
        if self.toolbox.yielding is None:
            return Failure.infeasible(f"{self.toolbox.model.description.name} has no hand that yields here")
        self._yielding = self.toolbox.yielding.start(order)
        return self._yielding.handle

    @property
    def led(self) -> YieldingMotion:
        """The motion that has begun.

        Raises:
            RuntimeError: None has.
        """
        if self._yielding is None:
            raise RuntimeError(f"{self.name} has not begun")
        return self._yielding
