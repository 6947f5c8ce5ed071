"""Look at a point with the whole body: the head first, then leaning over and turning the trunk too."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from kinematics.gaze import gaze_joints
from kinematics.robot_model import RobotModel

Array = NDArray[np.float64]

# Tried in turn, the smallest help first.
LEANS_RAD = (0.0, 0.15, 0.3, 0.45, 0.6, 0.7)
TURNS_RAD = (0.0, 0.2, -0.2, 0.4, -0.4, 0.6, -0.6, 0.8, -0.8, 1.1, -1.1)
# An aim that is this near to the point is good, and this near will do when there is none nearer.
AIMED_RAD = 0.01
GOOD_ENOUGH_RAD = 0.04


def body_gaze(
    model: RobotModel, q: Array, point: Array, turning_joint: str | None = None
) -> dict[str, float] | None:
    """Joint positions that bring a world point, shape (3,), to the middle of the picture.

    Args:
        model: The robot; its description says which joints pan, tilt and lean.
        q: Where the other joints are, shape (nq,).
        point: What to look at.
        turning_joint: A joint that turns the trunk, or None.

    Returns:
        Positions of the joints that aim, rad, or None when no posture that was tried looks there.
    """
    camera = model.description.camera
    leans = LEANS_RAD if camera.lean_joint is not None else (0.0,)
    turns = TURNS_RAD if turning_joint is not None else (0.0,)
    tries = sorted(
        ((lean, turn) for lean in leans for turn in turns), key=lambda pair: abs(pair[0]) + abs(pair[1])
    )
    best: tuple[float, dict[str, float]] | None = None
    for lean, turn in tries:
        joints = {}
        for joint, angle in ((camera.lean_joint, lean), (turning_joint, turn)):
            if joint is not None:
                index, margin = model.joint_index(joint), model.description.planning_margin_rad
                joints[joint] = float(
                    np.clip(angle, model.lower_rad[index] + margin, model.upper_rad[index] - margin)
                )
        trial = _with(model, q, joints)
        joints |= gaze_joints(model, trial, point)
        off = off_axis_rad(model, _with(model, q, joints), point)
        if off <= AIMED_RAD:
            return joints
        if best is None or off < best[0]:
            best = off, joints
    return best[1] if best is not None and best[0] <= GOOD_ENOUGH_RAD else None


def off_axis_rad(model: RobotModel, q: Array, point: Array) -> float:
    """Angle of a world point to the camera's optical axis."""
    world_T_camera = model.frame_pose(q, model.description.camera.frame)
    x, y, z = world_T_camera[:3, :3].T @ (point - world_T_camera[:3, 3])
    return math.atan2(math.hypot(x, y), z)


def _with(model: RobotModel, q: Array, joints: dict[str, float]) -> Array:
    q = q.copy()
    for joint, angle in joints.items():
        q[7 + model.joint_index(joint)] = angle
    return q
