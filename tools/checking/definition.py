"""What a trajectory says about any time: its definition, written once more for the referee."""

from __future__ import annotations

import numpy as np
import pinocchio as pin
from scipy.interpolate import CubicHermiteSpline

from kinematics.arrays import Array
from kinematics.motion.trajectory import Trajectory


class Definition:
    """A trajectory between its samples."""

    def __init__(self, trajectory: Trajectory) -> None:
        t, q, v = trajectory.t_s, trajectory.q, trajectory.v
        world = [pin.XYZQUATToSE3(row[:7]).rotation @ twist[:3] for row, twist in zip(q, v, strict=True)]
        self._base = CubicHermiteSpline(t, q[:, :3], np.array(world))
        self._joints = CubicHermiteSpline(t, q[:, 7:], v[:, 6:])
        self._t, self._quaternion = t, q[:, 3:7].copy()
        for i in range(1, len(t)):
            if self._quaternion[i] @ self._quaternion[i - 1] < 0.0:
                self._quaternion[i] *= -1.0

    def __call__(self, times: Array) -> Array:
        """Configurations, shape (n, nq), by time, shape (n,)."""
        blend = np.stack([np.interp(times, self._t, column) for column in self._quaternion.T], axis=1)
        blend /= np.linalg.norm(blend, axis=1, keepdims=True)
        return np.hstack([self._base(times), blend, self._joints(times)])
