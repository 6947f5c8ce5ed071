"""How an arm goes along with the trunk, so that what its hand holds stays upright before the shoulder."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from kinematics.arrays import Array, Sealed
from kinematics.geometry import poses
from kinematics.ik.arm_frames import ArmFrames, arm_kinematics, arm_share
from kinematics.ik.arm_posture import arm_posture
from kinematics.ik.body_gaze import with_joints
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel

UP = np.array([0.0, 0.0, 1.0])
BESIDE_M = (0.22, 0.36, 0.30)
"""Where a hand is that is in nobody's way, from its shoulder: ahead, outwards, down; of TALOS's arm."""
_TILT_RAD = 0.05
_LIES_RAD = math.radians(35.0)
# Nine centimetres beside its place, or a hand that is turned by 20 degrees, count as a degree of tilt.
_PLACE_WEIGHT, _HAND_WEIGHT = 0.2, 0.05


@dataclass(frozen=True, slots=True)
class HeldInHand(Sealed):
    """Where a held object is, by the hand's places."""

    tcp_T_object: poses.Transform

    def places_m(self, at: ArmFrames) -> Array:
        """Of its middle, shape (n, 3)."""
        return np.asarray(at.tcp_m + at.world_R_tcp @ self.tcp_T_object[:3, 3])

    def upwards(self, at: ArmFrames) -> Array:
        """Its axis that is up while it stands, shape (n, 3)."""
        return np.asarray(at.world_R_tcp @ self.tcp_T_object[:3, 2])

    def is_upright(self, at: ArmFrames, tilt_rad: float) -> bool:
        """Whether that is the vertical within an angle, in the first row."""
        return bool(self.upwards(at)[0, 2] >= math.cos(tilt_rad))


def unlike(a: Array, b: Array) -> Array:
    """Differences of directions as unit vectors; of shape (n, 3), the second one or shape (3,)."""
    return np.asarray(_unit(b) - _unit(a))


def arm_that_goes_along(
    model: RobotModel, q: Array, joints: Mapping[str, float], hand: Hand, tcp_T_object: poses.Transform
) -> dict[str, float] | None:
    """Positions of an arm's joints, rad, that hold a thing upright once other joints have moved.

    It stays before the shoulder, as the chest faces. What lies in the hand goes on lying as it does.

    Args:
        model: The robot.
        q: Configuration before, shape (nq,).
        joints: Where joints of the trunk and neck go, rad.
        hand: The hand that holds.
        tcp_T_object: Where it has the thing, shape (4, 4).

    Returns:
        None where the arm cannot.
    """
    arm, held = arm_kinematics(model, hand, trunk=False), HeldInHand(tcp_T_object)
    before = arm.at(q)
    moved = with_joints(q, model, joints)
    after = arm.at(moved)
    turn = poses.rotation_z(float(after.heading_rad[0] - before.heading_rad[0]))
    place = after.shoulder_m[0] + turn @ (held.places_m(before)[0] - before.shoulder_m[0])
    fingers = turn @ before.world_R_tcp[0, :, 0]
    up = UP if held.is_upright(before, _LIES_RAD) else turn @ held.upwards(before)[0]
    return _posture(model, moved, hand, held, _Wished(place, fingers, up))


def arm_beside(
    model: RobotModel, q: Array, hand: Hand, tcp_T_object: poses.Transform | None
) -> dict[str, float] | None:
    """Positions of an arm's joints, rad, that hold a hand beside the body, out of what is before the chest.

    Args:
        model: The robot.
        q: Where the other joints are, shape (nq,).
        hand: Whose arm.
        tcp_T_object: Where the hand has a thing that is to be upright, shape (4, 4); None of an empty hand.

    Returns:
        None where the arm cannot.
    """
    arm, share = arm_kinematics(model, hand, trunk=False), arm_share(model, hand)
    now = arm.at(q)
    facing = poses.rotation_z(float(now.heading_rad[0]))
    ahead, outwards, down = (share * measure for measure in BESIDE_M)
    side = 1.0 if hand == "left" else -1.0
    place = now.shoulder_m[0] + facing @ (ahead, side * outwards, -down)
    # an empty hand stays as it is turned
    level = poses.transform(now.world_R_tcp[0].T, (0.0, 0.0, 0.0))
    held = HeldInHand(level if tcp_T_object is None else tcp_T_object)
    return _posture(model, q, hand, held, _Wished(place, facing[:, 0], UP))


class _Wished(NamedTuple):
    """Where a held thing is to be, where the fingers point, and what is up, shape (3,) each."""

    place_m: Array
    fingers: Array
    up: Array


def _posture(
    model: RobotModel, q: Array, hand: Hand, held: HeldInHand, wished: _Wished
) -> dict[str, float] | None:
    """Positions of an arm's joints at which it is as wished for, upright above all."""
    arm = arm_kinematics(model, hand, trunk=False)

    def residual(at: ArmFrames) -> Array:
        return np.column_stack(
            [
                _PLACE_WEIGHT * (held.places_m(at) - wished.place_m),
                unlike(held.upwards(at), wished.up),
                _HAND_WEIGHT * unlike(at.world_R_tcp[:, :, 0], wished.fingers),
            ]
        )

    found = arm_posture(model, arm, q, residual, q[arm.columns])
    if float(held.upwards(arm.at(found.q))[0] @ wished.up) < math.cos(_TILT_RAD):
        return None
    return dict(zip(arm.joints, found.q[arm.columns].tolist(), strict=True))


def _unit(ways: Array) -> Array:
    return np.asarray(ways / np.sqrt(np.sum(ways * ways, axis=-1, keepdims=True)))
