"""The pendulum that a body with heavy legs is."""

import numpy as np
import pinocchio as pin
import pytest

from kinematics.geometry.planar import PlanarPose
from kinematics.model.robot_model import RobotModel
from kinematics.walking.body.whole_body import OutOfReachError, WholeBody
from kinematics.walking.pattern.com_motion import ComSample
from kinematics.walking.pattern.pattern_sample import PatternSample, Phase
from robots.models.description import load_description

PERIOD_S = 0.002


@pytest.mark.parametrize("robot", ["talos", "g1"])
@pytest.mark.parametrize("axis", [0, 1])
@pytest.mark.requirement("M6", "U4")
def test_the_pendulum_turns_its_legs_as_the_whole_body_does(robot, axis):
    """Of a point mass in the CoM the ZMP would be off by a seventh of its way (G1) on both axes."""
    model = RobotModel(load_description(robot))
    feet = {
        sole.side: PlanarPose.of(model.frame_pose(model.q_home, sole.frame))
        for sole in model.description.soles
    }
    body = WholeBody(model, model.q_home.copy(), feet, PERIOD_S, PERIOD_S)
    start = np.array(model.com(model.q_home)[:2])
    data = model.pin.createData()

    def zmp_of(acceleration_m_s2):
        """Of the whole body, at the turning point of a way of its CoM over soles that stay."""
        found = []
        for t_s in PERIOD_S * np.arange(-20, 21):
            com = start.copy()
            com[axis] += 0.5 * acceleration_m_s2 * t_s * t_s
            at = tuple(com)
            sample = PatternSample(
                ComSample(at, at, at, at), feet, {"left": 0.0, "right": 0.0}, ("left", "right"), Phase.SHIFT
            )
            try:
                found.append(body.follow(sample))
            except OutOfReachError:  # the first two have no neighbours yet
                assert not found
        motion = min(found, key=lambda each: float(np.abs(each.v[:2]).max()))
        wrench = pin.rnea(model.pin, data, motion.q, motion.v, motion.a)[:6]
        force, moment = wrench[:3], wrench[3:] + np.cross(motion.q[:3], wrench[:3])
        zmp = -moment[1] / force[2], moment[0] / force[2]
        return zmp[axis], float(model.com(motion.q)[axis])

    (rest, rest_com), (driven, driven_com) = zmp_of(0.0), zmp_of(1.0)

    swept = (driven_com - driven) - (rest_com - rest)
    assert swept == pytest.approx(1.0 / body.omega**2, rel=0.03)
