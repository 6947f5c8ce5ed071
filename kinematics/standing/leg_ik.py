"""Inverse kinematics of the legs: closed form where the hip's and the ankle's axes meet in a point.

Legs that are built otherwise are solved numerically, as exactly. The pelvis pose and the sole poses
give the legs, so a motion planned over pelvis, trunk and arms keeps the feet where they are by
construction. Closed form: Kajita, Hirukawa, Harada, Yokoi, "Introduction to Humanoid Robotics",
Springer 2014, section 2.5.2, for the axis order hip yaw, roll, pitch, knee pitch, ankle pitch, roll.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.errors import ModelError
from kinematics.geometry.poses import Transform
from kinematics.model.robot_description import HANDS
from kinematics.model.robot_model import RobotModel
from kinematics.model.standing_robot import StandingRobot
from kinematics.standing.numeric_leg import LegChain, NumericLeg

AXES = ("JointModelRZ", "JointModelRX", "JointModelRY", "JointModelRY", "JointModelRY", "JointModelRX")


@dataclass(frozen=True, slots=True)
class LegGeometry:
    """One leg over its planted foot, as the closed form sees it.

    Attributes:
        joints: Pinocchio's ids of the leg's joints, hip to ankle.
        hip_m: Where the hip's axes meet, in the base's frame, shape (3,).
        thigh_m, shin_m: Lengths of the bones.
        foot_R: ``world_R_ankle`` with the foot planted, shape (3, 3).
        ankle_m: Where the ankle's axes meet, in the world, shape (3,).
    """

    joints: tuple[int, ...]
    hip_m: Array
    thigh_m: float
    shin_m: float
    foot_R: Array
    ankle_m: Array


class LegIk:
    """Inverse kinematics of the legs of a robot on planted soles; a welded robot has no legs to place.

    Raises:
        ModelError: A leg is not a chain of six hinges.
    """

    def __init__(self, robot: StandingRobot) -> None:
        model, placed = robot.model, dict(robot.stance.soles)
        self._legs = [
            _leg(model, f"{side}_leg", sole.frame, placed[sole.frame])
            for side in HANDS
            for sole in model.description.soles
            if sole.side == side
        ]

    @property
    def closed(self) -> bool:
        """Whether there are legs, and all of them have a closed form."""
        return bool(self._legs) and all(isinstance(leg, _ClosedLeg) for leg in self._legs)

    def bent_knees(self) -> dict[str, tuple[float, float]]:
        """Limits of the knees of legs without a closed form, off where they are stretched, rad."""
        return {leg.knee: leg.bent_range() for leg in self._legs if isinstance(leg, NumericLeg)}

    @property
    def geometry(self) -> tuple[LegGeometry, ...]:
        """The legs' numbers, left first.

        Raises:
            ModelError: A leg has no closed form.
        """
        closed = [leg for leg in self._legs if isinstance(leg, _ClosedLeg)]
        if len(closed) < len(self._legs):
            raise ModelError("the legs have no closed form")
        return tuple(
            LegGeometry(leg.joints, leg.hip, leg.thigh, leg.shin, leg.foot_R, leg.ankle) for leg in closed
        )

    @property
    def chains(self) -> tuple[LegChain, ...]:
        """The hinges of legs without a closed form, left first.

        Raises:
            ModelError: A leg has one.
        """
        numeric = [leg for leg in self._legs if isinstance(leg, NumericLeg)]
        if len(numeric) < len(self._legs):
            raise ModelError("some legs have a closed form, and others have none")
        return tuple(leg.chain for leg in numeric)

    def fill(self, q: Array) -> NDArray[np.bool_]:
        """Write the leg joints into configurations, from their base poses.

        Args:
            q: Shape (n, nq); columns of the legs are overwritten, the others are read.

        Returns:
            Whether both feet can be reached, shape (n,). Joint limits are not judged here.
        """
        base_R = _rotations(q[:, 3:7])
        reachable = np.ones(len(q), dtype=bool)
        for leg in self._legs:
            reachable &= leg.fill(q, base_R)
        return reachable


def _leg(model: RobotModel, group: str, frame: str, world_T_sole: Transform) -> _ClosedLeg | NumericLeg:
    """One leg, solved in closed form where it can be."""
    ids = [model.pin.getJointId(name) for name in model.description.groups[group]]
    axes = tuple(model.pin.joints[i].shortname() for i in ids)
    offsets = [np.array(model.pin.jointPlacements[i].translation) for i in ids]
    if axes != AXES:
        return NumericLeg(model, group, frame, world_T_sole)
    straight = all(np.allclose(offsets[k][:2], 0.0) for k in (3, 4)) and all(
        np.allclose(offsets[k], 0.0) for k in (1, 2, 5)
    )
    turned = any(not np.allclose(model.pin.jointPlacements[i].rotation, np.eye(3)) for i in ids)
    if not straight or turned:
        return NumericLeg(model, group, frame, world_T_sole)
    return _ClosedLeg(model, group, frame, world_T_sole)


class _ClosedLeg:
    def __init__(self, model: RobotModel, group: str, frame: str, world_T_sole: Transform) -> None:
        ids = [model.pin.getJointId(name) for name in model.description.groups[group]]
        offsets = [np.array(model.pin.jointPlacements[i].translation) for i in ids]
        self.joints = tuple(int(i) for i in ids)
        self._columns = 7 + model.group(group)
        self.hip = offsets[0]
        self.thigh, self.shin = float(-offsets[3][2]), float(-offsets[4][2])
        ankle_T_sole = np.array(model.pin.frames[model.frame_id(frame)].placement.homogeneous)
        world_T_ankle = world_T_sole @ np.linalg.inv(ankle_T_sole)
        self.foot_R, self.ankle = world_T_ankle[:3, :3], world_T_ankle[:3, 3]

    def fill(self, q: Array, base_R: Array) -> NDArray[np.bool_]:
        hip = q[:, :3] + base_R @ self.hip
        r = (hip - self.ankle) @ self.foot_R
        a, b = self.thigh, self.shin
        distance = np.sqrt(np.sum(r * r, axis=1))
        cosine = (distance**2 - a * a - b * b) / (2.0 * a * b)
        reachable = np.abs(cosine) <= 1.0
        knee = np.arccos(np.clip(cosine, -1.0, 1.0))
        inner = np.arcsin(np.clip(a / np.maximum(distance, 1e-9) * np.sin(np.pi - knee), -1.0, 1.0))
        roll = np.arctan2(r[:, 1], r[:, 2])
        pitch = -np.arctan2(r[:, 0], np.hypot(r[:, 1], r[:, 2])) - inner
        # base_R_thigh, of which yaw, roll and pitch of the hip are read off
        bend = -pitch - knee
        m = np.swapaxes(base_R, 1, 2) @ self.foot_R @ _rot_x(-roll) @ _rot_y(bend)
        hip_yaw = np.arctan2(-m[:, 0, 1], m[:, 1, 1])
        hip_roll = np.arctan2(m[:, 2, 1], -m[:, 0, 1] * np.sin(hip_yaw) + m[:, 1, 1] * np.cos(hip_yaw))
        hip_pitch = np.arctan2(-m[:, 2, 0], m[:, 2, 2])
        q[:, self._columns] = np.stack([hip_yaw, hip_roll, hip_pitch, knee, pitch, roll], axis=1)
        return np.asarray(reachable)


def _rotations(xyzw: Array) -> Array:
    x, y, z, w = (xyzw / np.linalg.norm(xyzw, axis=1, keepdims=True)).T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    return np.moveaxis(np.array(rows), 2, 0)


def _rot_x(angle: Array) -> Array:
    c, s, one, zero = np.cos(angle), np.sin(angle), np.ones_like(angle), np.zeros_like(angle)
    return np.moveaxis(np.array([[one, zero, zero], [zero, c, -s], [zero, s, c]]), 2, 0)


def _rot_y(angle: Array) -> Array:
    c, s, one, zero = np.cos(angle), np.sin(angle), np.ones_like(angle), np.zeros_like(angle)
    return np.moveaxis(np.array([[c, zero, s], [zero, one, zero], [-s, zero, c]]), 2, 0)
