"""Positions, velocities and accelerations of a trajectory at any time, fast enough for a control loop."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pinocchio as pin

from kinematics.arrays import Array
from kinematics.motion.trajectory import Trajectory

_CONJUGATE = np.array([-1.0, -1.0, -1.0, 1.0])


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
    """Evaluates the interpolation that ``kinematics.motion.trajectory`` defines.

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
        velocity = np.hstack([rotate(q[:, 3:7], v[:, :3]), v[:, 6:]])
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
        self._powers = np.zeros((3, 4))
        self._powers[0, 0] = 1.0

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
        per_s = 1.0 / float(self._h_s[segment])
        u = (t_s - float(self._t_s[segment])) * per_s
        powers = self._powers
        powers[0, 1:] = u, u * u, u * u * u
        powers[1, 1:] = per_s, 2.0 * u * per_s, 3.0 * u * u * per_s
        powers[2, 2:] = 2.0 * per_s * per_s, 6.0 * u * per_s * per_s
        value, slope, curve = powers @ self._blocks[segment]
        n = self._joints
        q, v, a = np.empty(n + 7), np.empty(n + 6), np.empty(n + 6)
        orientation = pin.Quaternion(value[n + 3 : n + 7])
        orientation.normalize()
        q[:3], q[3:7], q[7:] = value[:3], orientation.coeffs(), value[3 : n + 3]
        v[3:6], v[6:] = value[n + 7 :], slope[3 : n + 3]
        a[3:6], a[6:] = slope[n + 7 :], curve[3 : n + 3]
        # The base's polynomial is in world axes, its twist in its own.
        rotation = orientation.matrix()
        v[:3], a[:3] = slope[:3] @ rotation, curve[:3] @ rotation
        a *= rate * rate
        a += rate_slope * v
        v *= rate
        vx, vy, vz, wx, wy, wz = v[:6].tolist()
        a[:3] -= (wy * vz - wz * vy, wz * vx - wx * vz, wx * vy - wy * vx)
        return MotionSample(q, v, a)

    def many(self, t_s: Array, rate: Array | None = None, rate_slope: Array | None = None) -> MotionSample:
        """Evaluate at many times, shape (k,) each; the arrays of the answer have k rows."""
        rate = np.ones(len(t_s)) if rate is None else rate
        rate_slope = np.zeros(len(t_s)) if rate_slope is None else rate_slope
        t_s = np.clip(t_s, 0.0, self.duration_s)
        segments = np.searchsorted(self._t_s, t_s, side="right") - 1
        segments = np.minimum(segments, len(self._h_s) - 1)
        per_s = 1.0 / self._h_s[segments]
        u = (t_s - self._t_s[segments]) * per_s
        powers = np.zeros((len(u), 3, 4))
        powers[:, 0] = np.stack([np.ones_like(u), u, u**2, u**3], axis=1)
        powers[:, 1, 1:] = np.stack([per_s, 2.0 * u * per_s, 3.0 * u**2 * per_s], axis=1)
        powers[:, 2, 2:] = np.stack([2.0 * per_s**2, 6.0 * u * per_s**2], axis=1)
        rows = powers @ self._blocks[segments]
        value, slope, curve = rows[:, 0], rows[:, 1], rows[:, 2]
        n, rate, rate_slope = self._joints, rate[:, None], rate_slope[:, None]
        quaternion = value[:, n + 3 : n + 7]
        quaternion = quaternion / np.linalg.norm(quaternion, axis=1, keepdims=True)
        q = np.hstack([value[:, :3], quaternion, value[:, 3 : n + 3]])
        own_axes = quaternion * _CONJUGATE
        twist = np.hstack([rotate(own_axes, slope[:, :3]), value[:, n + 7 :]])
        v = np.hstack([twist, slope[:, 3 : n + 3]])
        linear, angular = rotate(own_axes, curve[:, :3]), slope[:, n + 7 :]
        a = rate * rate * np.hstack([linear, angular, curve[:, 3 : n + 3]]) + rate_slope * v
        v *= rate
        a[:, :3] -= cross(v[:, 3:6], v[:, :3])
        return MotionSample(q, v, a)

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


def rotate(xyzw: Array, vectors: Array) -> Array:
    """Rotate vectors, shape (k, 3), by unit quaternions, shape (k, 4)."""
    axis, w = xyzw[:, :3], xyzw[:, 3:]
    twice = 2.0 * cross(axis, vectors)
    return np.asarray(vectors + w * twice + cross(axis, twice), dtype=np.float64)


def cross(a: Array, b: Array) -> Array:
    """Cross products of rows, shape (k, 3): for few rows in a sixth of numpy's time."""
    (ax, ay, az), (bx, by, bz) = a.T, b.T
    product = np.empty_like(b)
    product[:, 0] = ay * bz - az * by
    product[:, 1] = az * bx - ax * bz
    product[:, 2] = ax * by - ay * bx
    return product


def _continuous(xyzw: Array) -> Array:
    """Unit quaternions with signs chosen so that neighbours lie in one half-sphere, shape (k, 4)."""
    unit = xyzw / np.linalg.norm(xyzw, axis=1, keepdims=True)
    flips = np.where(np.sum(unit[1:] * unit[:-1], axis=1) < 0.0, -1.0, 1.0)
    unit[1:] *= np.cumprod(flips)[:, None]
    return np.asarray(unit, dtype=np.float64)
