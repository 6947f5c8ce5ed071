"""The trees' way to the feet, across the socket."""

from __future__ import annotations

from executive.live.control_client.control_link import ControlLink
from executive.live.control_client.motion_client import MotionClient
from kinematics.walking.pattern.steering import Steering
from robots.control.motion_handle import MotionHandle, MotionStatus
from robots.live.documents.steering_document import write_steering

_TOLD_AFTER_S = 0.1
"""Until then the other side's report may be older than what it was told."""


class WalkingClient:
    """Has a served robot walk; satisfies ``trees.toolbox.Walking``."""

    def __init__(self, link: ControlLink, motion: MotionClient) -> None:
        """Command through a link."""
        self._link, self._motion = link, motion
        self._handle: MotionHandle | None = None
        self._told_s = -_TOLD_AFTER_S

    @property
    def active(self) -> bool:
        """Whether a walk is under way, its last steps included."""
        if self._handle is None or self._handle.status in (MotionStatus.DONE, MotionStatus.REFUSED):
            return self._link.report.walking
        just_told = self._link.now_s < self._told_s + _TOLD_AFTER_S
        return self._link.report.walking or just_told or not self._handle.finished

    def walk(self, steering: Steering, name: str) -> MotionHandle:
        """Set out; refused when the robot does not stand at rest."""
        number, self._handle = self._motion.new(name)
        self._told_s = self._link.now_s
        self._link.walk(self._handle, number, write_steering(steering))
        return self._handle

    def steer(self, handle: MotionHandle, steering: Steering) -> None:
        """Go somewhere else with a walk that is under way."""
        self._link.steer(handle, write_steering(steering))

    def finish(self, handle: MotionHandle) -> None:
        """Come to an end within the last steps; the handle is done when the robot stands."""
        self._link.finish(handle)

    def cancel(self, handle: MotionHandle, reason: str) -> None:
        """The same, but the handle is cancelled at once."""
        if not handle.finished:
            self._told_s = self._link.now_s
            self._motion.cancel(handle, reason)
