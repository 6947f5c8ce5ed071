"""A leaf that walks and leaves the robot standing, whatever happens."""

from __future__ import annotations

from py_trees.common import Status

from robots.control.motion_handle import MotionHandle
from trees.failures import Failure
from trees.nodes.leaf import RUNNING, Leaf
from trees.nodes.motion_leaf import motion_failure


class WalkingLeaf(Leaf):
    """A leaf that makes one walk at a time, and leaves the robot standing whatever happens.

    When it ends early, the walk stops within its last steps.
    """

    _handle: MotionHandle | None = None

    def begin(self) -> None:
        """Forget the walk of an earlier run."""
        self._handle = None

    def ended_early(self, handle: MotionHandle) -> Status | Failure | None:
        """Why a walk ended before its time, once its last steps are made: nothing else moves before."""
        ended = motion_failure(handle)
        if ended is not None and self.toolbox.walking is not None and self.toolbox.walking.active:
            return RUNNING
        return ended

    def release(self, reason: str) -> None:
        """Stop within the last steps."""
        if self._handle is not None and self.toolbox.walking is not None:
            self.toolbox.walking.cancel(self._handle, reason)
