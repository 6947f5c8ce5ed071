"""Time a curve so that a standing robot does not tip: as fast as the joints allow, or slower."""

from __future__ import annotations

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from kinematics.curves import Curve
from kinematics.free_coordinates import FreeCoordinates
from kinematics.robot_model import RobotModel
from kinematics.stance import SupportPolygon
from kinematics.timing import Pace, time_curve
from kinematics.trajectory import Stance, Trajectory
from kinematics.trajectory_sampler import TrajectorySampler

Array = NDArray[np.float64]

ZMP_RESERVE_M = 0.01
"""The ZMP stays this far inside the support polygon; the checker asks for less."""
SLOWER = (1.0, 0.8, 0.62, 0.48, 0.36, 0.26)
"""Shares of the pace that are tried. The ZMP leaves the CoM by the square of the speed."""
_PERIOD_S = 0.02
_GRAVITY_M_S2 = 9.81


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
        if zmp_margin_m(model, trajectory) >= ZMP_RESERVE_M:
            return trajectory
    return None


def zmp_margin_m(model: RobotModel, trajectory: Trajectory) -> float:
    """Least distance of the ZMP to the edge of the support polygon, positive inside, m."""
    polygon = SupportPolygon(trajectory.stance, model.description.soles)
    sampler = TrajectorySampler(trajectory)
    times: Array = np.arange(0.0, sampler.duration_s, _PERIOD_S, dtype=np.float64)
    motion = sampler.many(times)
    data = model.pin.createData()
    zmp = np.empty((len(times), 2))
    mass = pin.computeTotalMass(model.pin)
    for k in range(len(times)):
        pin.computeCentroidalMomentumTimeVariation(model.pin, data, motion.q[k], motion.v[k], motion.a[k])
        force, moment = data.dhg.linear, data.dhg.angular
        # wrench of the ground at the CoM: the momentum's rate less gravity
        up = force[2] + mass * _GRAVITY_M_S2
        com = data.com[0]
        zmp[k, 0] = com[0] - (com[2] * force[0] + moment[1]) / up
        zmp[k, 1] = com[1] - (com[2] * force[1] - moment[0]) / up
    return float(polygon.margins_m(zmp).min())
