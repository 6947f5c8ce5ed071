"""A leaf whose hand yields to what it holds or meets."""

from __future__ import annotations

from robots.control.motion_handle import MotionHandle
from robots.control.yield_order import YieldOrder
from trees.failures import Failure
from trees.motion_leaf import MotionLeaf
from trees.toolbox import YieldingMotion


class YieldingLeaf(MotionLeaf):
    """Starts one yielding hand, follows it, cancels it when the leaf ends early."""

    _yielding: YieldingMotion | None = None

    def begin(self) -> None:
        """Forget the motion of an earlier run."""
        super().begin()
        self._yielding = None

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
