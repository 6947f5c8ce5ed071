"""Time a curve so that a standing robot does not tip: as fast as the joints allow, or slower."""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array
from kinematics.dynamics.zmp import balance_margins_m
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.curves import Curve
from kinematics.motion.sampler import MotionSample
from kinematics.motion.trajectory import Trajectory
from kinematics.timing.curve_timing import CurveTimer, Pace

ZMP_RESERVE_M = 0.03
"""The ZMP stays this far inside the support polygon; the checker asks for less."""
ZMP_BESIDE_COM_M = 0.01
"""Where the CoM itself is nearer to the edge, the ZMP may be nearer by this."""
SLOWER = (1.0, 0.8, 0.62, 0.48, 0.36, 0.26)
"""Shares of the pace that are tried. The ZMP leaves the CoM by the square of the speed."""
_DOUBT_M = 0.002
"""A pace is left out where the margins of a faster one say that it lacks more than this."""
_EVERY = 4
"""Samples between two looks at the ZMP; the checker looks twice as often."""


def time_in_balance(robot: StandingRobot, curve: Curve, pace: Pace) -> Trajectory | None:
    """Make the trajectory that runs a curve from rest to rest within all limits and in balance.

    Args:
        robot: Where it stands.
        curve: Through its free coordinates.
        pace: The shares of its limits that are tried first.

    Returns:
        The trajectory, or None when the legs cannot follow, or the robot would tip at any pace.
    """
    timer = CurveTimer(robot, curve)
    hopeless = 1.0
    for share in SLOWER:
        if share > hopeless:
            continue
        trajectory = timer.at(Pace(pace.velocity * share, pace.acceleration * share * share))
        if trajectory is None:
            return None
        zmp, com = _margins_m(robot, trajectory)
        if _least_room(zmp, com) >= 0.0:
            return trajectory
        # slower, the ZMP is nearer to the CoM by the square of the speed
        less = [other for other in SLOWER if other < share]
        rooms = [_least_room(com + (zmp - com) * (other / share) ** 2, com) for other in less]
        hopeless = next(
            (other for other, room in zip(less, rooms, strict=True) if room > -_DOUBT_M), SLOWER[-1]
        )
    return None


def _least_room(zmp: Array, com: Array) -> float:
    """How much nearer the ZMP might come to the edge, m; negative where it is too near."""
    return float(zmp.min()) - min(ZMP_RESERVE_M, float(com.min()) - ZMP_BESIDE_COM_M)


def _margins_m(robot: StandingRobot, trajectory: Trajectory) -> tuple[Array, Array]:
    """Distances of ZMP and CoM to the edge of the support polygon at some instants."""
    t_s, v = trajectory.t_s, trajectory.v
    some = np.arange(1, len(t_s) - 1, _EVERY)
    acceleration = (v[some + 1] - v[some - 1]) / (t_s[some + 1] - t_s[some - 1])[:, None]
    motion = MotionSample(trajectory.q[some], v[some], acceleration)
    return balance_margins_m(robot, motion)
