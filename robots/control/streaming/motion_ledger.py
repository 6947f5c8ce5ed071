"""The handles of motions: each is begun, refused or ended once, and told of."""

from __future__ import annotations

from robots.clock import Clock
from robots.control.events import ControlSink, MotionEnded, MotionStarted
from robots.control.motion_handle import MotionHandle, MotionStatus


class MotionLedger:
    """Makes handles with owners of their own, and tells what becomes of them."""

    def __init__(self, clock: Clock, sink: ControlSink) -> None:
        """Begin with none.

        Args:
            clock: For the stamps of events.
            sink: Where events go.
        """
        self._clock = clock
        self._sink = sink
        self._count = 0

    def open(self, name: str) -> MotionHandle:
        """A handle for a motion that is to start."""
        self._count += 1
        return MotionHandle(name, f"motion-{self._count}")

    def begun(self, handle: MotionHandle) -> None:
        """Tell that it moves."""
        self._sink(MotionStarted(self._clock.now_s(), handle.name, handle.owner))

    def refuse(self, handle: MotionHandle, reason: str) -> MotionHandle:
        """End it before it began."""
        self.end(handle, MotionStatus.REFUSED, reason)
        return handle

    def end(self, handle: MotionHandle, status: MotionStatus, reason: str) -> None:
        """Write how it ended, and tell."""
        handle.status, handle.reason = status, reason
        self._sink(MotionEnded(self._clock.now_s(), handle.name, handle.owner, status.value, reason))
