"""A fast motion to and fro, which a brake finds hard before each of its turns."""

import numpy as np

from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.curves import RoundedPolyline
from kinematics.standing.free_coordinates import free_coordinates
from kinematics.timing.balanced_timing import time_in_balance
from kinematics.timing.curve_timing import Pace

WAVING = Pace(0.7, 0.9)
"""As fast as waving may be."""


def swing(talos, stance, pace=WAVING):
    """A raised hand goes to and fro: a trajectory."""
    space = free_coordinates(StandingRobot(talos, stance))
    ends = np.repeat(space.from_q(talos.q_home)[None], 4, axis=0)
    for joint, rad in (("arm_left_2_joint", 0.45), ("arm_left_3_joint", -0.35)):
        ends[1::2, space.index(joint)] += rad
        ends[2, space.index(joint)] -= rad
    curve = RoundedPolyline(ends, space.weights, 0.06)
    return time_in_balance(StandingRobot(talos, stance), curve, pace)
