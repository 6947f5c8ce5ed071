"""A leaf that sets the robot in motion and leaves it holding, whatever happens."""

from __future__ import annotations

from py_trees.common import Status

from robots.control.motion_handle import MotionHandle, MotionStatus
from trees.failures import Failure, FailureKind, Reason
from trees.nodes.leaf import DONE, RUNNING, Leaf


class MotionLeaf(Leaf):
    """A leaf that makes one motion.

    It starts the motion, follows its handle, and cancels it when the leaf is halted or fails before the
    motion has ended.
    """

    _handle: MotionHandle | None = None

    def start(self) -> MotionHandle | Failure | None:
        """Begin the motion, or say why it must not begin; None when nothing has to be done."""
        raise NotImplementedError

    def finish(self) -> Status | Failure:
        """After the motion is done: ``RUNNING`` until the postcondition is measured."""
        return DONE

    def begin(self) -> None:
        """Forget the motion of an earlier run; the motion itself starts with the first step."""
        self._handle = None

    def step(self) -> Status | Failure:
        """Follow the motion."""
        if self._handle is None:
            started = self.start()
            if started is None:
                return DONE
            if isinstance(started, Failure):
                return started
            self._handle = started
        if (ended := motion_failure(self._handle)) is not None:
            return ended
        if self._handle.status is MotionStatus.RUNNING:
            self.feedback_message = f"{self._handle.progress:.0%}"
            return RUNNING
        self.feedback_message = ""
        return self.finish()

    def release(self, reason: str) -> None:
        """Brake and hold."""
        if self._handle is not None and not self._handle.finished:
            self.toolbox.motion.cancel(self._handle, reason)


def motion_failure(handle: MotionHandle) -> Failure | None:
    """Why a motion ended before its time, or None."""
    if handle.status is MotionStatus.REFUSED:
        refused = Failure.refused(f"{handle.name} was refused: {handle.reason}", progress=handle.progress)
        return refused.because(Reason.FELT_IN_THE_WAY) if handle.met_something else refused
    if handle.status is MotionStatus.CANCELED:
        return Failure(
            FailureKind.EXECUTION,
            f"{handle.name} was stopped: {handle.reason}",
            {"progress": handle.progress},
        )
    return None
