"""Positions, velocities and accelerations of a trajectory at any time, fast enough for a control loop."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.trajectory import Trajectory

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class MotionSample:
    """One instant of a motion, or many when each array has a leading axis.

    Attributes:
        q: Configuration, shape (nq,).
        v: Velocity, shape (nv,), base twist in the base's own frame.
        a: Acceleration, shape (nv,), derivative of ``v``.
    """

    q: Array
    v: Array
    a: Array


class TrajectorySampler:
    """Evaluates the interpolation that ``kinematics.trajectory`` defines.

    All polynomials are laid out beforehand, one (4, m) block a segment with rows for the powers
    0 to 3 of the fraction of the segment; an evaluation is one small matrix product. The columns
    are base position (3, world), joints (n), base quaternion (4), and the base's angular velocity
    (3, own frame), the last two with straight lines between the samples.
    """

    def __init__(self, trajectory: Trajectory) -> None:
        """Prepare a trajectory."""
        q, v = trajectory.q, trajectory.v
        n = len(trajectory.joints)
        self._joints = n
        self._t_s = trajectory.t_s
        self._h_s = np.diff(trajectory.t_s)
        position = np.hstack([q[:, :3], q[:, 7:]])
        velocity = np.hstack([_rotate(q[:, 3:7], v[:, :3]), v[:, 6:]])
        quaternion = _continuous(q[:, 3:7])
        h = self._h_s[:, None]
        start, end = position[:-1], position[1:]
        start_slope, end_slope = h * velocity[:-1], h * velocity[1:]
        self._blocks = np.zeros((len(h), 4, n + 10))
        cubic = self._blocks[:, :, : n + 3]
        cubic[:, 0] = start
        cubic[:, 1] = start_slope
        cubic[:, 2] = 3.0 * (end - start) - 2.0 * start_slope - end_slope
        cubic[:, 3] = 2.0 * (start - end) + start_slope + end_slope
        linear = np.hstack([quaternion, v[:, 3:6]])
        self._blocks[:, 0, n + 3 :] = linear[:-1]
        self._blocks[:, 1, n + 3 :] = np.diff(linear, axis=0)
        self._segment = 0

    @property
    def duration_s(self) -> float:
        """Time of the last sample."""
        return float(self._t_s[-1])

    def at(self, t_s: float, rate: float = 1.0, rate_slope: float = 0.0) -> MotionSample:
        """Evaluate at one time, clipped to the trajectory's own.

        Args:
            t_s: Time along the trajectory.
            rate: How fast that time passes: less than 1 while it is being braked.
            rate_slope: How fast the rate changes, 1/s.
        """
        t_s = min(max(t_s, 0.0), self.duration_s)
        segment = self._find(t_s)
        h = float(self._h_s[segment])
        u = (t_s - float(self._t_s[segment])) / h
        powers = np.array(
            [[1.0, u, u * u, u * u * u], [0.0, 1.0, 2.0 * u, 3.0 * u * u], [0.0, 0.0, 2.0, 6.0 * u]]
        )
        value, slope, curve = powers @ self._blocks[segment]
        n = self._joints
        q, v, a = np.empty(n + 7), np.empty(n + 6), np.empty(n + 6)
        quaternion = value[n + 3 : n + 7]
        quaternion = quaternion / np.sqrt(quaternion @ quaternion)
        q[:3], q[3:7], q[7:] = value[:3], quaternion, value[3 : n + 3]
        slope *= 1.0 / h
        curve *= 1.0 / (h * h)
        v[6:] = rate * slope[3 : n + 3]
        a[6:] = (rate * rate) * curve[3 : n + 3] + rate_slope * slope[3 : n + 3]
        omega = value[n + 7 :]
        v[3:6] = rate * omega
        a[3:6] = (rate * rate) * slope[n + 7 :] + rate_slope * omega
        into_base = quaternion * (-1.0, -1.0, -1.0, 1.0)
        linear = np.stack([rate * slope[:3], rate * rate * curve[:3] + rate_slope * slope[:3]])
        if linear.any():
            linear = _rotate(np.stack([into_base, into_base]), linear)
            linear[1] -= np.cross(v[3:6], linear[0])
        v[:3], a[:3] = linear
        return MotionSample(q, v, a)

    def many(self, t_s: Array, rate: Array, rate_slope: Array) -> MotionSample:
        """Evaluate at many times, shape (k,) each; the arrays of the answer have k rows."""
        rows = zip(t_s.tolist(), rate.tolist(), rate_slope.tolist(), strict=True)
        samples = [self.at(*row) for row in rows]
        return MotionSample(
            np.array([sample.q for sample in samples]),
            np.array([sample.v for sample in samples]),
            np.array([sample.a for sample in samples]),
        )

    def _find(self, t_s: float) -> int:
        """Index of the segment that holds a time; the next one is tried before searching."""
        last = len(self._h_s) - 1
        for segment in (self._segment, min(self._segment + 1, last)):
            if self._t_s[segment] <= t_s <= self._t_s[segment + 1]:
                break
        else:
            segment = min(int(np.searchsorted(self._t_s, t_s, side="right")) - 1, last)
        self._segment = segment
        return segment


def _rotate(xyzw: Array, vectors: Array) -> Array:
    """Rotate vectors, shape (k, 3), by unit quaternions, shape (k, 4)."""
    axis, w = xyzw[:, :3], xyzw[:, 3:]
    twice = 2.0 * np.cross(axis, vectors)
    return np.asarray(vectors + w * twice + np.cross(axis, twice), dtype=np.float64)


def _continuous(xyzw: Array) -> Array:
    """Unit quaternions with signs chosen so that neighbours lie in one half-sphere, shape (k, 4)."""
    unit = xyzw / np.linalg.norm(xyzw, axis=1, keepdims=True)
    flips = np.where(np.sum(unit[1:] * unit[:-1], axis=1) < 0.0, -1.0, 1.0)
    unit[1:] *= np.cumprod(flips)[:, None]
    return np.asarray(unit, dtype=np.float64)
