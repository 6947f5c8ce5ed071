"""The product's grasps of a request's target, as data for those who know nothing of its grippers."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from kinematics.model.robot_model import RobotModel
from kinematics.planning.grasps import GraspCandidate, grasp_table
from kinematics.planning.pick_task import APPROACH_M, FARTHEST_M
from kinematics.requests.pick import PickRequest


def natural_grasps(model: RobotModel, request: PickRequest, heights: Sequence[float]) -> list[GraspCandidate]:
    """Grasps of all hands that may be used and are in reach, in the product's order."""
    found: list[GraspCandidate] = []
    target = request.scene.objects[request.target]
    for hand in request.hands:
        joint = model.pin.getJointId(model.description.groups[f"{hand}_arm"][1])
        shoulder = next(frame.name for frame in model.pin.frames if frame.parentJoint == joint)
        offset = (target.world_T_object - model.frame_pose(request.q_start, shoulder))[:3, 3]
        if np.linalg.norm(offset[:2]) > FARTHEST_M:
            continue
        heading = float(np.arctan2(offset[1], offset[0]))
        cost = 2.0 * math.hypot(offset[0], offset[1])
        gripper = model.description.grippers[hand]
        table = grasp_table(target, gripper, heading, APPROACH_M, heights, cost)
        found += [table.candidate(row) for row in range(len(table))]
    return sorted(found, key=lambda item: item.cost)
