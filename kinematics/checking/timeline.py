"""A trajectory between its samples: the motion that ``Trajectory`` defines, at any time.

Cubic Hermite polynomials of the joints and of the base's position, normalised blend of the base's
quaternions. Beside values it gives bounds that hold for *every* instant of an interval, which is
what turns a check at some instants into a proof for all.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array, as_float64
from kinematics.motion.trajectory import Trajectory


@dataclass(frozen=True, slots=True)
class Configurations:
    """Configurations at n instants.

    Attributes:
        t_s: Times, shape (n,).
        base_position_m: World position of the base, shape (n, 3).
        base_quaternion: Its orientation (x, y, z, w), shape (n, 4).
        base_rotation: The same as ``world_R_base``, shape (n, 3, 3).
        joints_rad: Joint positions, shape (n, k).
    """

    t_s: Array
    base_position_m: Array
    base_quaternion: Array
    base_rotation: Array
    joints_rad: Array


class Timeline:
    """A trajectory as a function of time.

    Attributes:
        t_s: Sample times, shape (n,).
        spacing_s: Their differences, shape (n - 1,).
        joints_rad, joint_velocity: At the samples, shape (n, k).
        base_position_m, base_velocity: World position and world velocity of the base at the samples,
            shape (n, 3).
        quaternions: Unit quaternions (x, y, z, w) at the samples, neighbours on the same side of the
            sphere, shape (n, 4).
        base_turn_rad: Angle between neighbouring base orientations, shape (n - 1,).
    """

    def __init__(self, trajectory: Trajectory) -> None:
        # compiled code takes writeable arrays: times are copied here, columns wherever they are joined
        t_s, q, v = as_float64(trajectory.t_s), trajectory.q, trajectory.v
        self.t_s = t_s
        self.spacing_s = np.diff(t_s)
        self.joints_rad = q[:, 7:]
        self.joint_velocity = v[:, 6:]
        self.base_position_m = q[:, :3]
        self.quaternions = _continuous(q[:, 3:7])
        # the chord's length gives small angles without the cancellation of arccos
        chord = np.linalg.norm(np.diff(self.quaternions, axis=0), axis=1)
        self.base_turn_rad = 4.0 * np.arcsin(np.minimum(0.5 * chord, 1.0))
        self._turns = bool(self.base_turn_rad.any())
        rotation = self._rotations(self.quaternions)
        self.base_velocity = np.einsum("nij,nj->ni", rotation, v[:, :3])
        self.duration_s = float(t_s[-1])
        self._values = np.hstack([self.base_position_m, self.joints_rad])
        self._rates = np.hstack([self.base_velocity, self.joint_velocity])
        self._accelerations: tuple[Array, Array] | None = None

    def at(self, t_s: Array) -> Configurations:
        """Configurations at some times within the trajectory, shape (m,)."""
        if t_s is self.t_s:
            values, quaternions = self._values, self.quaternions
        else:
            values, quaternions, _ = self._evaluate(t_s, with_rates=False)
        return Configurations(t_s, values[:, :3], quaternions, self._rotations(quaternions), values[:, 3:])

    def knots(self, spacing_s: float) -> Array:
        """Times from start to end, evenly spaced, not farther apart than ``spacing_s``; an odd number."""
        count = 2 * max(1, int(np.ceil(self.duration_s / (2.0 * spacing_s))))
        return np.linspace(0.0, self.duration_s, count + 1)

    def path_lengths(self, knots_s: Array) -> Array:
        """How far everything moves between neighbouring knots: a bound from above.

        Args:
            knots_s: Rising times, shape (m + 1,).

        Returns:
            Shape (m, 2 + k): length of the base's path (m), angle that the base sweeps (rad), then
            the path length of each joint (rad), back and forth counted. A cubic's path is no longer
            than its control polygon, so these hold whatever happens between the knots.
        """
        inside = (self.t_s > knots_s[0]) & (self.t_s < knots_s[-1])
        times = np.union1d(knots_s, self.t_s[inside])
        values, quaternions, rates = self._evaluate(times)
        third = np.diff(times)[:, None] / 3.0
        first, last = rates[:-1] * third, rates[1:] * third
        middle = np.diff(values, axis=0) - first - last
        base = sum(np.linalg.norm(leg[:, :3], axis=1) for leg in (first, middle, last))
        joints = np.abs(first[:, 3:]) + np.abs(middle[:, 3:]) + np.abs(last[:, 3:])
        chord = np.linalg.norm(np.diff(quaternions, axis=0), axis=1)
        turn = 4.0 * np.arcsin(np.minimum(0.5 * chord, 1.0))
        lengths = np.column_stack([base, turn, joints])
        starts = np.searchsorted(times, knots_s[:-1])
        return np.add.reduceat(lengths, starts, axis=0)

    def arrays(self) -> tuple[Array, Array, Array, Array]:
        """Times, values (base position, joints), their rates, and base quaternions at the samples."""
        return self.t_s, self._values, self._rates, self.quaternions

    def bend(self, joints: Sequence[int] | None = None) -> Array:
        """How far each segment may leave the straight line between its samples, shape (n - 1, 1 + k).

        First the base (m), then the joints (rad), all of them or those asked for. The base's orientation
        has none by definition.
        """
        values, rates = self._values, self._rates
        if joints is not None:
            columns = [0, 1, 2, *(3 + joint for joint in joints)]
            values, rates = values[:, columns], rates[:, columns]
        change = values[1:] - values[:-1]
        h = self.spacing_s[:, None]
        early, late = rates[:-1] * h - change, change - rates[1:] * h
        # the Hermite terms u (1-u)^2 and u^2 (1-u) have their maximum of 4/27
        bound = (4.0 / 27.0) * (np.abs(early) + np.abs(late))
        return np.column_stack([np.linalg.norm(bound[:, :3], axis=1), bound[:, 3:]])

    def rests(self, joints: Sequence[int]) -> bool:
        """Tell whether the base and some joints stay where they are, between the samples too."""
        still = (self.base_turn_rad, self.base_velocity, self.joint_velocity[:, joints])
        if any(array.any() for array in still):
            return False
        places = (self.base_position_m, self.joints_rad[:, joints])
        return all(bool((array == array[0]).all()) for array in places)

    def accelerations(self) -> tuple[Array, Array]:
        """Of the joints at the beginning and at the end of each segment, shape (n - 1, k) each."""
        if self._accelerations is None:
            h = self.spacing_s[:, None]
            q, v = self.joints_rad, self.joint_velocity
            slope = np.diff(q, axis=0) / h
            early = (6.0 * slope - 4.0 * v[:-1] - 2.0 * v[1:]) / h
            late = (-6.0 * slope + 2.0 * v[:-1] + 4.0 * v[1:]) / h
            self._accelerations = (early, late)
        return self._accelerations

    def _rotations(self, quaternions: Array) -> Array:
        """Those of the base at some times, shape (m, 3, 3); most motions do not turn it."""
        if self._turns:
            return rotations(quaternions)
        found = np.empty((len(quaternions), 3, 3))
        found[:] = rotations(self.quaternions[:1])
        return found

    def _evaluate(self, t_s: Array, with_rates: bool = True) -> tuple[Array, Array, Array]:
        """Values (base position, joints), base quaternions, and the values' rates, unless nobody asks."""
        i = np.clip(np.searchsorted(self.t_s, t_s, side="right") - 1, 0, len(self.t_s) - 2)
        h = self.spacing_s[i][:, None]
        u = (t_s - self.t_s[i])[:, None] / h
        p0, p1 = self._values[i], self._values[i + 1]
        m0, m1 = self._rates[i] * h, self._rates[i + 1] * h
        change = p1 - p0
        bow, lean = m0 - change, change - m1
        w = 1.0 - u
        values = p0 + u * change + u * w * (w * bow + u * lean)
        quaternions = (1.0 - u) * self.quaternions[i] + u * self.quaternions[i + 1]
        quaternions /= np.linalg.norm(quaternions, axis=1, keepdims=True)
        if not with_rates:
            return values, quaternions, values
        rates = (change + w * (1.0 - 3.0 * u) * bow + u * (2.0 - 3.0 * u) * lean) / h
        return values, quaternions, rates


def _continuous(quaternions: Array) -> Array:
    """Made unit quaternions, shape (n, 4), each on the side of the sphere where the one before is."""
    if (quaternions == quaternions[0]).all():
        unit = quaternions[0] / max(float(np.linalg.norm(quaternions[0])), 1e-9)
        return np.tile(unit, (len(quaternions), 1))
    norm = np.maximum(np.linalg.norm(quaternions, axis=1, keepdims=True), 1e-9)
    quaternions = quaternions / norm
    dots = np.einsum("ni,ni->n", quaternions[:-1], quaternions[1:])
    flips = np.cumprod(np.where(dots < 0.0, -1.0, 1.0))
    return np.asarray(quaternions * np.concatenate([[1.0], flips])[:, None])


def rotations(quaternions: Array) -> Array:
    """Rotation matrices, shape (n, 3, 3), of unit quaternions (x, y, z, w), shape (n, 4)."""
    x, y, z, w = quaternions.T
    found = np.empty((len(quaternions), 3, 3))
    found[:, 0, 0] = 1 - 2 * (y * y + z * z)
    found[:, 0, 1] = 2 * (x * y - z * w)
    found[:, 0, 2] = 2 * (x * z + y * w)
    found[:, 1, 0] = 2 * (x * y + z * w)
    found[:, 1, 1] = 1 - 2 * (x * x + z * z)
    found[:, 1, 2] = 2 * (y * z - x * w)
    found[:, 2, 0] = 2 * (x * z - y * w)
    found[:, 2, 1] = 2 * (y * z + x * w)
    found[:, 2, 2] = 1 - 2 * (x * x + y * y)
    return found
