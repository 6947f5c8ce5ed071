"""A leaf that walks and leaves the robot standing, whatever happens."""

from __future__ import annotations

from robots.control.motion_handle import MotionHandle
from trees.leaf import Leaf


class WalkingLeaf(Leaf):
    """Follows one walk at a time, and stops it within its last steps when the leaf ends early."""

    _handle: MotionHandle | None = None

    def begin(self) -> None:
        """Forget the walk of an earlier run."""
        self._handle = None

    def release(self, reason: str) -> None:
        """Stop within the last steps."""
        if self._handle is not None and self.toolbox.walking is not None:
            self.toolbox.walking.cancel(self._handle, reason)
