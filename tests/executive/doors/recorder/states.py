"""States and a belief to be recorded."""

import numpy as np

from kinematics.model.stance import Stance
from robots.interface.gripper_reading import GripperReading
from robots.interface.robot import RobotState
from robots.interface.sensed_state import SensedState
from robots.live.documents.robot_report import ReportLayout, RobotReport

CUP = {
    "name": "red cup 1",
    "kind": "cup",
    "is": "object",
    "shape": "cylinder",
    "size_m": [0.035, 0.1],
    "place_m": [0.6, -0.2, 0.8],
    "quaternion": [0.0, 0.0, 0.0, 1.0],
    "margin_m": 0.01,
    "confidence": 0.9,
    "error_m": [0.002, 0.003, 0.004],
}


def row_at(model, t_s):
    description = model.description
    n, feet = len(description.actuated), len(description.soles)
    q = np.zeros(model.nq)
    q[:7] = 0.1 * t_s, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0
    read = RobotState(
        t_s, np.full(n, t_s), np.zeros(n), np.ones(n), np.zeros(3), np.zeros(3), np.zeros((feet, 6))
    )
    soles = Stance(tuple((sole.frame, np.eye(4)) for sole in description.soles))
    grippers = {hand: GripperReading(hand, 0.1, 0.05, 0.2, False) for hand in description.grippers}
    return ReportLayout(model).row(
        RobotReport(t_s, True, False, SensedState(read, lambda: q.copy()), q, soles, grippers)
    )
