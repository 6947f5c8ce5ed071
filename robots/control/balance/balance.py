"""Feed-forward efforts that carry the body, so that stiff position servos need not sag to find them."""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array
from kinematics.dynamics.held_load import loaded
from kinematics.dynamics.standing_dynamics import StandingDynamics
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.sampler import MotionSample
from kinematics.motion.trajectory import HeldLoad

_SHIFT_PERIODS = 100
"""What a load adds comes and goes within these: a step of some Nm would swing the arm."""


class Balance:
    """Computes the joints' feed-forward efforts for each instant of the body's reference motion.

    Balance itself comes from planned motions that keep the CoM inside and from stiff joints; these
    efforts (weight and inertia, less what the ground carries) keep the joints from giving way. On
    the simulated TALOS inertia matters: without it a quick wave of both arms is tracked to 4.4 mrad
    instead of 0.8. An ankle torque from the DCM's error does not: it moved the largest push that the
    robot survives by 4 % at most (240 N forward, 270 back, 380 sideways, 0.1 s), so there is none. What
    swings on afterwards is for ``SwayDamping``.
    """

    def __init__(self, standing: StandingRobot) -> None:
        """Prepare for one stance, with nothing in the hands."""
        self._standing = standing
        self._dynamics = StandingDynamics(standing)
        self._loads: tuple[HeldLoad, ...] = ()
        self._for: MotionSample | None = None
        self._efforts = np.zeros(len(standing.model.joints))
        self._fading: Array | None = None
        self._periods_left = 0

    def carry(self, loads: tuple[HeldLoad, ...]) -> None:
        """Bear what the hands carry from now on; once efforts were asked for, what is new comes gently."""
        if loads == self._loads:
            return
        self._loads = loads
        model, stance = self._standing.model, self._standing.stance
        self._dynamics = StandingDynamics(StandingRobot.of(loaded(model, loads), stance))
        self._periods_left = 0 if self._for is None else _SHIFT_PERIODS
        self._fading = None

    def efforts(self, sample: MotionSample) -> Array:
        """Feed-forward of the body joints, Nm, shape (n,); computed once for a sample that holds."""
        if self._periods_left > 0:
            wanted = self._dynamics.efforts(sample.q, sample.v, sample.a)
            if self._fading is None:
                self._fading = (self._efforts - wanted) / _SHIFT_PERIODS
            self._periods_left -= 1
            self._efforts, self._for = wanted + self._periods_left * self._fading, sample
        elif sample is not self._for:
            self._efforts = self._dynamics.efforts(sample.q, sample.v, sample.a)
            self._for = sample
        return self._efforts
