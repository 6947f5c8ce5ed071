"""Smooth whole-body motions with the feet where they are, in unit time; and their timing."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation

from kinematics.arrays import Array
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance
from kinematics.motion.trajectory import Trajectory
from tools.checking.profiles import Profile, random_profile

PELVIS = ("x", "y", "z", "yaw", "pitch")
_PELVIS_SIZE = {"x": 0.04, "y": 0.05, "z": 0.06, "yaw": 0.15, "pitch": 0.1}
_LEG_INSTANTS = np.linspace(0.0, 1.0, 121)
_GROUPS = ("left_arm", "right_arm", "torso", "head")


class UnfitMotionError(Exception):
    """A random motion that cannot be used: the feet cannot stay, or it would take too long."""


@dataclass(frozen=True)
class Motion:
    """Profiles over unit time.

    Attributes:
        joints: Joint index in ``q[7:]`` to the offset from ``q_start``.
        pelvis: Name in ``PELVIS`` to the offset of the base.
    """

    joints: Mapping[int, Profile]
    pelvis: Mapping[str, Profile] = field(default_factory=dict)


def stance_at_home(model: RobotModel) -> Stance:
    """Both soles where the home posture has them."""
    return Stance(
        tuple((sole.frame, model.frame_pose(model.q_home, sole.frame)) for sole in model.description.soles)
    )


def random_motion(model: RobotModel, rng: np.random.Generator, groups: Sequence[str] = ()) -> Motion:
    """Some groups move within their limits; in a third of the cases the pelvis does too."""
    drawn = list(groups) or [group for group in _GROUPS if rng.random() < 0.55]
    chosen = [group for group in drawn if len(model.group(group))] or ["right_arm"]
    size = rng.choice([0.2, 0.5, 1.0])
    joints = {}
    s = np.linspace(0.0, 1.0, 200)
    for group in chosen:
        for index in model.group(group):
            room = np.array([model.lower_rad[index], model.upper_rad[index]]) - model.q_home[7 + index]
            scale = 0.25 * size if group == "torso" else size
            profile = random_profile(rng, scale)
            values = profile(s)[0]
            fit = min(
                1.0,
                0.97 * room[1] / max(values.max(), 1e-9),
                0.97 * room[0] / min(values.min(), -1e-9),
            )
            joints[int(index)] = profile.scaled(fit)
    pelvis = {}
    if not model.description.welded and rng.random() < 0.35:
        for name in PELVIS:
            if rng.random() < 0.6:
                pelvis[name] = random_profile(rng, _PELVIS_SIZE[name])
    return Motion(joints, pelvis)


class Choreographer:
    """Turns motions into trajectories of one robot."""

    def __init__(self, model: RobotModel) -> None:
        self.model = model
        self.stance = stance_at_home(model)
        self._data = model.pin.createData()
        self._known: tuple[Motion, Array, CubicSpline] | None = None
        self._feet = [
            (model.frame_id(name), pin.SE3(world_T_sole), self._leg_columns(model.frame_id(name)))
            for name, world_T_sole in self.stance.soles
        ]

    def _leg_columns(self, frame: int) -> NDArray[np.intp]:
        pin.computeJointJacobians(self.model.pin, self._data, self.model.q_home)
        jacobian = pin.getFrameJacobian(self.model.pin, self._data, frame, pin.LOCAL)
        return np.flatnonzero(np.abs(jacobian[:, 6:]).any(axis=0)) + 6

    def unit(self, motion: Motion, s: Array, exact_at: Array = _LEG_INSTANTS) -> tuple[Array, Array]:
        """Configurations, shape (n, nq), and derivatives with respect to s, shape (n, nv).

        Args:
            motion: The motion.
            s: Instants, shape (n,).
            exact_at: Where the feet are kept exactly; a cubic spline runs between.

        Raises:
            UnfitMotionError: The feet cannot stay.
        """
        model = self.model
        q, v = np.tile(model.q_home, (len(s), 1)), np.zeros((len(s), model.nv))
        for index, profile in motion.joints.items():
            values, rates = profile(s)
            q[:, 7 + index] += values
            v[:, 6 + index] = rates
        if motion.pelvis:
            self._move_pelvis(motion, s, q, v, exact_at)
        return q, v

    def _move_pelvis(self, motion: Motion, s: Array, q: Array, v: Array, exact_at: Array) -> None:
        q[:, :7], v[:, :6] = self._base(motion, s)
        columns = np.concatenate([columns for _, _, columns in self._feet])
        legs = self._legs(motion, exact_at)
        q[:, columns + 1], v[:, columns] = legs(s), legs(s, 1)

    def _base(self, motion: Motion, s: Array) -> tuple[Array, Array]:
        """Base pose (position, quaternion) and twist in its own frame."""
        still = np.zeros_like(s)
        place = {name: motion.pelvis[name](s) if name in motion.pelvis else (still, still) for name in PELVIS}
        home = pin.XYZQUATToSE3(self.model.q_home[:7])
        heading = Rotation.from_rotvec(np.outer(place["yaw"][0], (0.0, 0.0, 1.0)))
        leaning = Rotation.from_rotvec(np.outer(place["pitch"][0], (0.0, 1.0, 0.0)))
        rotation = heading * leaning * Rotation.from_matrix(home.rotation)
        shift, velocity = (np.column_stack([place[name][k] for name in ("x", "y", "z")]) for k in (0, 1))
        spin = heading.apply(np.outer(place["pitch"][1], (0.0, 1.0, 0.0)))
        spin[:, 2] += place["yaw"][1]
        pose = np.hstack([home.translation + shift, rotation.as_quat()])
        return pose, np.hstack([rotation.apply(velocity, inverse=True), rotation.apply(spin, inverse=True)])

    def _legs(self, motion: Motion, s: Array) -> CubicSpline:
        """Leg joints that keep the feet: exact at some instants, a cubic spline between."""
        if self._known is not None and self._known[0] is motion and self._known[1] is s:
            return self._known[2]
        q, v = np.tile(self.model.q_home, (len(s), 1)), np.zeros((len(s), self.model.nv))
        q[:, :7], v[:, :6] = self._base(motion, s)
        columns = np.concatenate([columns for _, _, columns in self._feet])
        for i in range(len(s)):
            if i:
                q[i, columns + 1] = q[i - 1, columns + 1] + v[i - 1, columns] * (s[i] - s[i - 1])
            self._keep_feet(q[i], v[i])
        legs = CubicSpline(s, q[:, columns + 1], bc_type=((1, v[0, columns]), (1, v[-1, columns])))
        self._known = motion, s, legs
        return legs

    def _keep_feet(self, q: Array, v: Array) -> None:
        model, data = self.model.pin, self._data
        for _ in range(20):
            pin.computeJointJacobians(model, data, q)
            pin.updateFramePlacements(model, data)
            worst = 0.0
            for frame, target, columns in self._feet:
                error = pin.log6(data.oMf[frame].actInv(target)).vector
                worst = max(worst, float(np.abs(error).max()))
                jacobian = pin.getFrameJacobian(model, data, frame, pin.LOCAL)[:, columns]
                q[columns + 1] += np.linalg.solve(jacobian + 1e-9 * np.eye(6), error)
            if worst < 1e-9:
                break
        else:
            raise UnfitMotionError
        if (q[7:] < self.model.lower_rad).any() or (q[7:] > self.model.upper_rad).any():
            raise UnfitMotionError
        pin.computeJointJacobians(model, data, q)
        for frame, _, columns in self._feet:
            jacobian = pin.getFrameJacobian(model, data, frame, pin.LOCAL)
            v[columns] = -np.linalg.solve(jacobian[:, columns], jacobian[:, :6] @ v[:6])

    def ratios(self, motion: Motion) -> tuple[Array, Array, Array]:
        """Largest speed, acceleration and jerk in unit time over their limits, by joint."""
        s = np.linspace(0.0, 1.0, 401)
        _, v = self.unit(motion, s)
        rate = v[:, 6:]
        second = np.gradient(rate, s, axis=0)
        third = np.gradient(second, s, axis=0)
        return (
            np.abs(rate).max(axis=0) / self.model.velocity,
            np.abs(second).max(axis=0) / self.model.acceleration,
            np.abs(third).max(axis=0) / self.model.jerk,
        )

    def duration(self, motion: Motion, use: float) -> float:
        """Duration at which the most demanding limit is used to the fraction ``use``."""
        speed, acceleration, jerk = self.ratios(motion)
        return float(
            max(speed.max() / use, np.sqrt(acceleration.max() / use), np.cbrt(jerk.max() / use), 0.3)
        )

    def trajectory(
        self, motion: Motion, duration_s: float, times_s: Array, exact_at: Array = _LEG_INSTANTS
    ) -> Trajectory:
        """Sample a motion at some times; ``exact_at`` as for ``unit``.

        Raises:
            UnfitMotionError: The feet cannot stay.
        """
        q, v = self.unit(motion, times_s / duration_s, exact_at)
        return Trajectory(self.model.joints, self.stance, times_s, q, v / duration_s)


def sample_times(rng: np.random.Generator, duration_s: float) -> Array:
    """Even spacing of 2 to 20 ms, or uneven spacing."""
    spacing = float(rng.choice([0.002, 0.004, 0.005, 0.01, 0.01, 0.02]))
    count = max(2, int(np.ceil(duration_s / spacing)))
    if rng.random() < 0.1:
        steps = rng.uniform(0.6, 1.4, count)
        return np.concatenate([[0.0], np.cumsum(steps) / steps.sum() * duration_s])
    return np.linspace(0.0, duration_s, count + 1)


def quaternion_product(a: Array, b: Array) -> Array:
    """Product of two quaternions (x, y, z, w)."""
    xyz = a[3] * b[:3] + b[3] * a[:3] + np.cross(a[:3], b[:3])
    return np.append(xyz, a[3] * b[3] - a[:3] @ b[:3])
