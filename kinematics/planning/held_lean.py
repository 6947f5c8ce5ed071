"""How far what hands hold leans on a way between two upright postures, and a way that keeps it level."""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array
from kinematics.model.robot_model import RobotModel
from kinematics.motion.curves import Curve, PolynomialCurve
from kinematics.planning.path_planner import PathPlanner
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing.free_coordinates import FreeCoordinates

MOST_LEAN_RAD = 0.1
"""What carries something open may lean it by so much on a way, beyond what it leans at both ends."""
_LITTLE_RAD = 0.03
"""By so much it may lean without a look for a way that keeps it level."""
_ALONG = np.linspace(0.0, 1.0, 17)
_BETWEEN = (0.25, 0.5, 0.75)
_TURNS = 12
_LEVEL_RAD = 1e-3


def leaned_rad(model: RobotModel, space: FreeCoordinates, curve: Curve, scene: PlanningScene) -> float:
    """How much farther than at its ends anything in a hand leans along a curve, at most; 0 with empty hands.

    Args:
        model: The robot.
        space: Whose coordinates the curve runs through.
        curve: The way.
        scene: Tells what is in hands.
    """
    held = list(scene.attached.values())
    if not held:
        return 0.0
    configurations, _ = space.to_q(curve(_ALONG))
    frames = [body.frame for body in held]
    own = np.array([body.frame_T_object[:3, 2] for body in held])
    vertical = np.array([[frame[2, :3] for frame in model.frame_poses(q, frames)] for q in configurations])
    leans = np.arccos(np.clip(np.sum(vertical * own, axis=2), -1.0, 1.0))
    return float(np.max(leans - np.maximum(leans[0], leans[-1])))


def least_leaning(
    planner: PathPlanner, model: RobotModel, space: FreeCoordinates, curve: Curve, scene: PlanningScene
) -> tuple[float, Curve]:
    """A free curve, or where what hands hold leans on it a level one between its ends, if that is free too.

    Returns:
        How far things lean on what is returned, and the curve.
    """
    lean_rad = leaned_rad(model, space, curve, scene)
    if lean_rad > _LITTLE_RAD:
        first, last = curve(np.array([0.0, 1.0]))
        level = level_way(model, space, (first, last), scene)
        if level is not None and planner.curve_is_free(level):
            return leaned_rad(model, space, level, scene), level
    return lean_rad, curve


def level_way(
    model: RobotModel, space: FreeCoordinates, ends: tuple[Array, Array], scene: PlanningScene
) -> Curve | None:
    """The straight line between two points, with arms that turn on it so that what they hold does not lean.

    It leans on it as at the ends, in between by as much as lies between these. Nothing else is looked at: the
    way may touch things. None where an arm cannot keep something level.

    Args:
        model: The robot.
        space: Whose coordinates these are.
        ends: Where it starts and ends, shape (size,) each.
        scene: Tells what is in hands.
    """
    rows = np.array([ends[0] + share * (ends[1] - ends[0]) for share in (0.0, *_BETWEEN, 1.0)])
    for body in scene.attached.values():
        hand = next((one for one, tcp in model.description.tcp_frames.items() if tcp == body.frame), None)
        if hand is None:
            return None
        joints = model.description.groups[f"{hand}_arm"]
        columns = [space.index(joint) for joint in joints]
        turned = 6 + model.indices(joints)
        own = body.frame_T_object[:3, 2]
        (first, last), _ = space.to_q(rows[[0, -1]])
        begins, arrives = (model.frame_pose(q, body.frame)[:3, :3] @ own for q in (first, last))
        for row, share in zip(rows[1:-1], _BETWEEN, strict=True):
            wanted = begins + share * (arrives - begins)
            for _ in range(_TURNS):
                q = space.to_q(row[None, :])[0][0]
                axis = model.frame_pose(q, body.frame)[:3, :3] @ own
                off = np.cross(axis, wanted)
                if float(np.linalg.norm(off)) < _LEVEL_RAD:
                    break
                # a turn about the axis itself is free
                turns = model.frame_jacobian(q, body.frame)[3:, turned]
                across = turns - np.outer(axis, axis @ turns)
                row[columns] += np.linalg.lstsq(across, off, rcond=1e-3)[0]
            else:
                return None
    return PolynomialCurve(rows)
