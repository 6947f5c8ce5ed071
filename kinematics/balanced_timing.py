"""Time a curve so that a standing robot does not tip: as fast as the joints allow, or slower."""

from __future__ import annotations

import numpy as np

from kinematics.curves import Curve
from kinematics.free_coordinates import FreeCoordinates
from kinematics.robot_model import RobotModel
from kinematics.timing import Pace, time_curve
from kinematics.trajectory import Stance, Trajectory
from kinematics.trajectory_sampler import MotionSample
from kinematics.zmp import balance_margins_m

ZMP_RESERVE_M = 0.03
"""The ZMP stays this far inside the support polygon; the checker asks for less."""
ZMP_BESIDE_COM_M = 0.01
"""Where the CoM itself is nearer to the edge, the ZMP may be nearer by this."""
SLOWER = (1.0, 0.8, 0.62, 0.48, 0.36, 0.26)
"""Shares of the pace that are tried. The ZMP leaves the CoM by the square of the speed."""
_EVERY = 4
"""Samples between two looks at the ZMP; the checker looks twice as often."""


def time_in_balance(
    model: RobotModel, space: FreeCoordinates, stance: Stance, curve: Curve, pace: Pace
) -> Trajectory | None:
    """Make the trajectory that runs a curve from rest to rest within all limits and in balance.

    Returns:
        The trajectory, or None when the legs cannot follow, or the robot would tip at any pace.
    """
    for share in SLOWER:
        slower = Pace(pace.velocity * share, pace.acceleration * share * share)
        trajectory = time_curve(model, space, stance, curve, slower)
        if trajectory is None:
            return None
        if _in_balance(model, trajectory):
            return trajectory
    return None


def _in_balance(model: RobotModel, trajectory: Trajectory) -> bool:
    t_s, v = trajectory.t_s, trajectory.v
    some = np.arange(1, len(t_s) - 1, _EVERY)
    acceleration = (v[some + 1] - v[some - 1]) / (t_s[some + 1] - t_s[some - 1])[:, None]
    motion = MotionSample(trajectory.q[some], v[some], acceleration)
    zmp, com = balance_margins_m(model, trajectory.stance, motion)
    return bool(zmp.min() >= min(ZMP_RESERVE_M, com.min() - ZMP_BESIDE_COM_M))
