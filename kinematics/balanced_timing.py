"""Time a curve so that a standing robot does not tip: as fast as the joints allow, or slower."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.curves import Curve
from kinematics.free_coordinates import FreeCoordinates
from kinematics.robot_model import RobotModel
from kinematics.timing import Pace, time_curve
from kinematics.trajectory import Stance, Trajectory
from kinematics.trajectory_sampler import TrajectorySampler
from kinematics.zmp import balance_margins_m

Array = NDArray[np.float64]

ZMP_RESERVE_M = 0.03
"""The ZMP stays this far inside the support polygon; the checker asks for less."""
ZMP_BESIDE_COM_M = 0.01
"""Where the CoM itself is nearer to the edge, the ZMP may be nearer by this."""
SLOWER = (1.0, 0.8, 0.62, 0.48, 0.36, 0.26)
"""Shares of the pace that are tried. The ZMP leaves the CoM by the square of the speed."""
_PERIOD_S = 0.04
"""Between two looks at the ZMP; the checker looks twice as often."""


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
    sampler = TrajectorySampler(trajectory)
    times: Array = np.arange(0.0, sampler.duration_s, _PERIOD_S, dtype=np.float64)
    zmp, com = balance_margins_m(model, trajectory.stance, sampler.many(times))
    return bool(zmp.min() >= min(ZMP_RESERVE_M, com.min() - ZMP_BESIDE_COM_M))
