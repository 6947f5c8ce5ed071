"""Look at a point with the whole body: the head first, then the trunk, and the pelvis at last."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.ik.gaze import aiming_joints
from kinematics.model.robot_model import RobotModel

# Tried in turn, the smallest help first.
LEANS_RAD = (0.0, 0.15, 0.3, 0.45, 0.6, 0.7)
TURNS_RAD = (0.0, 0.2, -0.2, 0.4, -0.4, 0.6, -0.6, 0.8, -0.8, 1.1, -1.1)
# Where the pelvis goes, from where it is, when the trunk alone does not get there (ahead, left, up): eyes
# that lean over a high table are soon straight above what stands at its edge.
PELVIS_M = ((0.0, 0.0, 0.0), (-0.03, 0.0, 0.0), (-0.06, 0.0, 0.0), (-0.09, 0.0, 0.0))
# An aim that is this near to the point is good, and this near will do when there is none nearer.
AIMED_RAD = 0.01
GOOD_ENOUGH_RAD = 0.04
# Worse than this, and the pelvis is asked to help.
DOUBTFUL_RAD = 0.02


@dataclass(frozen=True, slots=True)
class BodyGaze:
    """How the body looks at a point.

    Attributes:
        joints: Positions of the joints that aim, rad.
        pelvis_m: How far the pelvis goes, ahead of the robot, to its left and up.
        off_rad: Angle that is left between the point and the middle of the picture.
    """

    joints: Mapping[str, float]
    pelvis_m: tuple[float, float, float]
    off_rad: float


def body_gaze(
    model: RobotModel,
    q: Array,
    point: Array,
    turning_joint: str | None = None,
    aimed_rad: float = AIMED_RAD,
) -> BodyGaze | None:
    """How to bring a world point, shape (3,), to the middle of the picture.

    Args:
        model: The robot; its description says which joints pan, tilt and lean.
        q: Where the other joints are, shape (nq,).
        point: What to look at.
        turning_joint: A joint that turns the trunk, or None.
        aimed_rad: An aim that is this near to the point is taken.

    Returns:
        The least help that looks there, or None when no posture that was tried does.
    """
    best: BodyGaze | None = None
    for pelvis_m in PELVIS_M[:1] if model.description.welded else PELVIS_M:
        gaze = _with_trunk(model, q, point, turning_joint, pelvis_m, aimed_rad)
        if best is None or gaze.off_rad < best.off_rad:
            best = gaze
        if best.off_rad <= max(DOUBTFUL_RAD, aimed_rad):
            break
    return best if best is not None and best.off_rad <= max(GOOD_ENOUGH_RAD, aimed_rad) else None


def _with_trunk(
    model: RobotModel,
    q: Array,
    point: Array,
    turning_joint: str | None,
    pelvis_m: tuple[float, float, float],
    aimed_rad: float,
) -> BodyGaze:
    """The smallest lean and turn that aim well, or those that aim best."""
    camera = model.description.camera
    leans = LEANS_RAD if camera.lean_joint is not None else (0.0,)
    turns = TURNS_RAD if turning_joint is not None and camera.trunk is None else (0.0,)
    tries = sorted(
        ((lean, turn) for lean in leans for turn in turns), key=lambda pair: abs(pair[0]) + abs(pair[1])
    )
    shifted = q.copy()
    shifted[:3] += pelvis_offset(q, pelvis_m)
    best: BodyGaze | None = None
    for lean, turn in tries:
        joints = {}
        for joint, angle in ((camera.lean_joint, lean), (turning_joint, turn)):
            if joint is not None:
                index, margin = model.joint_index(joint), model.description.planning_margin_rad
                joints[joint] = float(
                    np.clip(angle, model.lower_rad[index] + margin, model.upper_rad[index] - margin)
                )
        joints |= aiming_joints(model, with_joints(shifted, model, joints), point)
        off = off_axis_rad(model, with_joints(shifted, model, joints), point)
        if best is None or off < best.off_rad:
            best = BodyGaze(joints, pelvis_m, off)
        if off <= aimed_rad:
            break
    if best is None:
        raise RuntimeError("no posture was tried")
    return best


def pelvis_offset(q: Array, pelvis_m: Sequence[float]) -> Array:
    """A way of the pelvis, ahead, to the left and up, in the world, shape (3,)."""
    yaw = poses.yaw_of(poses.rotation_from_quaternion(q[3:7]))
    return np.asarray(poses.rotation_z(yaw) @ np.asarray(pelvis_m))


def off_axis_rad(model: RobotModel, q: Array, point: Array) -> float:
    """Angle of a world point to the camera's optical axis."""
    world_T_camera = model.frame_pose(q, model.description.camera.frame)
    x, y, z = world_T_camera[:3, :3].T @ (point - world_T_camera[:3, 3])
    return math.atan2(math.hypot(x, y), z)


def with_joints(q: Array, model: RobotModel, joints: Mapping[str, float]) -> Array:
    """A configuration, shape (nq,), with some joints elsewhere, rad."""
    q = q.copy()
    for joint, angle in joints.items():
        q[7 + model.joint_index(joint)] = angle
    return q
