"""Walks of the fake robot: each period the step that the steering asks for, from standing to standing."""

from __future__ import annotations

from kinematics.geometry.planar import PlanarPose
from kinematics.walking.pattern.steering import Steering
from robots.control.motion_handle import MotionHandle, MotionStatus
from robots.fake.fake_motion import FakeMotion

# A walk that is refused midway has come so far.
_MIDWAY_STEPS = 2


class FakeWalking:
    """Walks of the fake robot; satisfies ``trees.toolbox.Walking``, and stands at once when it is stopped.

    Attributes:
        hangs: While true, no step is made.
    """

    def __init__(self, motion: FakeMotion) -> None:
        """Stand where the motion has the feet."""
        self.hangs = False
        self._motion = motion
        self._handle: MotionHandle | None = None
        self._steering: Steering | None = None
        self._before = PlanarPose()
        self._steps = 0

    @property
    def active(self) -> bool:
        """Whether a walk is under way."""
        return self._handle is not None and not self._handle.finished

    def walk(self, steering: Steering, name: str) -> MotionHandle:
        """Set out; refused while something moves."""
        if self._motion.moving:
            handle = self._motion.note(name)
            handle.status, handle.reason = MotionStatus.REFUSED, "the robot does not stand at rest"
            return handle
        self._handle, self._steering = self._motion.note(name), steering
        self._before, self._steps = PlanarPose(), 0
        return self._handle

    def steer(self, handle: MotionHandle, steering: Steering) -> None:
        """Go somewhere else from the next step on."""
        if handle is self._handle:
            self._steering = steering

    def finish(self, handle: MotionHandle) -> None:
        """Stand; the walk is done with the next period."""
        if handle is self._handle:
            self._steering = None

    def cancel(self, handle: MotionHandle, reason: str) -> None:
        """Stand at once."""
        self._motion.cancel(handle, reason)

    def advance(self) -> None:
        """Make the next step, or end."""
        if self._handle is None or self._handle.finished or self.hangs:
            return
        if self._motion.refuse_midway and self._steps >= _MIDWAY_STEPS:
            self._handle.status, self._handle.reason = MotionStatus.REFUSED, self._motion.refuse_midway
            return
        steering = self._steering
        step = None if steering is None else steering.advance(self._motion.feet(), self._before)
        if step is None:
            self._handle.status, self._handle.progress = MotionStatus.DONE, 1.0
            return
        self._motion.step_by(step)
        self._before, self._steps = step, self._steps + 1
