"""Odometry of the feet, against bodies that move above soles at rest."""

import numpy as np
import pytest

from kinematics.model.robot_model import RobotModel
from kinematics.walking.body.legged_estimator import LeggedEstimator
from robots.models.description import load_description

PERIOD_S = 0.002
WEIGHT_N = 900.0


class Leaning:
    """TALOS whose legs lean ahead together, so that its base moves while both soles stand still."""

    def __init__(self):
        self.model = RobotModel(load_description("talos"))
        self.q = self.model.q_home.copy()
        soles = {
            sole.side: self.model.frame_pose(self.q, sole.frame) for sole in self.model.description.soles
        }
        self.q[2] -= soles["left"][2, 3]
        self.true = {side: pose[:2, 3].copy() for side, pose in soles.items()}
        for pose in soles.values():
            pose[2, 3] = 0.0
        self.estimator = LeggedEstimator(self.model, self.q, soles, np.zeros(3))
        legs = [self.model.description.groups[f"{side}_leg"] for side in ("left", "right")]
        self.hips = self.model.indices([leg[2] for leg in legs])
        self.ankles = self.model.indices([leg[4] for leg in legs])
        self.sides = [sole.side for sole in self.model.description.soles]
        self.now_s = 0.0

    def lean(self, seconds, left_share, rad_s=0.4):
        """Go on leaning with that much of the weight on the left foot."""
        for _ in range(round(seconds / PERIOD_S)):
            self.now_s += PERIOD_S
            v = np.zeros(len(self.model.joints))
            v[self.hips], v[self.ankles] = rad_s, -rad_s
            self.q[7:] += PERIOD_S * v
            wrench = np.zeros((2, 6))
            for k, side in enumerate(self.sides):
                wrench[k, 2] = WEIGHT_N * (left_share if side == "left" else 1.0 - left_share)
            self.estimator.update(self.now_s, self.q[7:], v, np.zeros(3), np.array([0.0, 0.0, 9.81]), wrench)

    def off_m(self, side):
        """How far from where a sole stands it is believed to be."""
        seen = self.estimator.sole(side)
        return np.hypot(seen.x_m - self.true[side][0], seen.y_m - self.true[side][1])


@pytest.mark.requirement("M6")
def test_a_change_of_feet_leaves_no_error_while_the_base_moves():
    robot = Leaning()

    robot.lean(0.05, left_share=1.0)
    for left_share in (0.0, 1.0, 0.0, 1.0):
        robot.lean(0.05, left_share)

    assert robot.off_m("left") < 1e-5
    assert robot.off_m("right") < 1e-5


def test_the_base_is_where_the_carrying_foot_has_it():
    robot = Leaning()
    before = robot.estimator.tilt_rad[:3].copy()

    robot.lean(0.1, left_share=0.8)

    moved = robot.estimator.tilt_rad[:3] - before
    assert abs(moved[0]) > 0.02
    assert abs(moved[1]) < 1e-5


def test_feet_without_load_leave_the_base_to_the_last_one_that_carried():
    robot = Leaning()
    robot.lean(0.05, left_share=1.0)

    robot.now_s += PERIOD_S
    still = np.zeros(len(robot.model.joints))
    robot.estimator.update(
        robot.now_s, robot.q[7:], still, np.zeros(3), np.array([0.0, 0.0, 9.81]), np.zeros((2, 6))
    )

    assert robot.estimator.loads_n == {"left": 0.0, "right": 0.0}
    assert robot.off_m("left") < 1e-5
