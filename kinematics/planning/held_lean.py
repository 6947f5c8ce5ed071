"""How far what hands hold leans on a way between two postures that hold it upright."""

from __future__ import annotations

import numpy as np

from kinematics.model.robot_model import RobotModel
from kinematics.motion.curves import Curve
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing.free_coordinates import FreeCoordinates

MOST_LEAN_RAD = 0.1
"""What carries something open may lean it by so much on a way, beyond what it leans at both ends."""
_ALONG = np.linspace(0.0, 1.0, 17)


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
