"""Where an arm points."""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel


def beside_ray_m(start: Array, through: Array, point: Array) -> float:
    """Distance of a point from the ray from ``start`` through another point; infinite behind its start.

    Args:
        start, through, point: World points, shape (3,) each.
    """
    way = (through - start) / np.linalg.norm(through - start)
    along = float((point - start) @ way)
    return float(np.linalg.norm(point - start - along * way)) if along > 0.0 else np.inf


def link_moved_by(model: RobotModel, joint: str) -> str:
    """Name of the link that a joint moves; its origin is on the joint's axis."""
    return model.moved_links[joint]


def elbow_frame(model: RobotModel, hand: Hand) -> str:
    """The link that an arm's fourth joint moves: the forearm begins at its origin."""
    return link_moved_by(model, model.description.groups[f"{hand}_arm"][3])


def pointing_error_m(model: RobotModel, q: Array, hand: Hand, target: Array) -> float:
    """Distance of a world point, shape (3,), from the line through an arm's forearm and hand."""
    elbow, tcp = model.frame_poses(q, [elbow_frame(model, hand), model.description.tcp_frames[hand]])
    return beside_ray_m(elbow[:3, 3], tcp[:3, 3], target)
