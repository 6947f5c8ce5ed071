"""One guarded motion while it runs."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from kinematics.motion.sampler import MotionSample
from robots.control.gate.refusal import Refusal
from robots.control.guarded.body_checker import BodyChecker
from robots.control.guarded.guarded_motion import BodyMotion, GuardedMotion
from robots.control.guarded.online_checker import OnlineChecker
from robots.control.motion_handle import MotionHandle
from robots.interface.robot import RobotState


class GuardedTrack:
    """A guarded motion with its handle, its checker and its last setpoint.

    Attributes:
        handle: What the one who started it holds.
        indices: Its joints among the actuated ones.
        moves_body: Whether one of them is a body joint.
        q, v: Its last setpoint, one entry a joint.
        body: The same with the base, of a whole-body motion; None of any other.
        in_contact: Whether it holds something that may not move.
        done: Whether it said so.
    """

    def __init__(
        self,
        motion: GuardedMotion,
        handle: MotionHandle,
        actuated: Sequence[str],
        bodies: int,
        body_checker: BodyChecker | None = None,
    ) -> None:
        """Begin.

        Args:
            motion: The motion.
            handle: Its handle.
            actuated: Names of the actuated joints.
            bodies: How many of these, from the first, are body joints.
            body_checker: Judges the setpoints of a whole-body motion.
        """
        bounds = motion.bounds
        self._motion = motion
        # asked once: whether a motion has all that one of the body has is found out by reading each of it
        self._body_motion = motion if isinstance(motion, BodyMotion) else None
        self._duration_s = bounds.duration_s
        self.indices = np.array([actuated.index(name) for name in bounds.joints], dtype=np.intp)
        self._checker = OnlineChecker(bounds, self.indices)
        self._elapsed_s = 0.0
        self.handle = handle
        self.moves_body = bool((self.indices < bodies).any())
        self.q: NDArray[np.float64] = np.empty(0)
        self.v: NDArray[np.float64] = np.empty(0)
        self.body: MotionSample | None = None
        self.in_contact = self._body_motion is not None and self._body_motion.in_contact
        self._body_checker = body_checker
        self.done = False

    def advance(self, period_s: float, state: RobotState) -> Refusal | None:
        """Ask the motion for its next setpoint and judge it."""
        sample = self._motion.sample(self._elapsed_s, state)
        if sample is None:
            self.done = True
            return None
        self.q, self.v = sample
        self._elapsed_s += period_s
        self.handle.progress = min(1.0, self._elapsed_s / self._duration_s)
        refusal = self._checker.judge(self._elapsed_s, self.q, self.v, state)
        if refusal is None and self._body_checker is not None and self._body_motion is not None:
            self.body = self._body_motion.body
            refusal = self._body_checker.judge()
        return refusal
