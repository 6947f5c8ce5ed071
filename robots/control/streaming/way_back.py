"""The way back along a path that has just been braked on, to where an ailing joint of a leg carries less.

A knee that gives a tenth of its effort sinks slowly where it is bent most, and the robot falls seconds after
it came to rest. Where it came from, less was asked of it, and the way there was checked already.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.dynamics.standing_dynamics import StandingDynamics
from kinematics.geometry.quintic import PEAK, rest_to_rest
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.sampler import MotionSample, TrajectorySampler
from robots.control.streaming.stop_profile import StopProfile, resting_on_the_stance

_BACK_S = tuple(0.1 * k for k in range(1, 8))
"""So much of the path may be gone back on, in its own time."""
_RATE = 0.6
"""Most of the path's own speed: faster, and its jerk would leave the limits."""
_EASED = 0.95
"""A joint that carries less than this share of what it carries at rest is eased."""
_STRAYED_RAD = 2e-3
"""Who rests farther than this beside the path is not on it any more."""
_BRAKED_WITHIN_S = 0.5


def way_back(
    robot: StandingRobot,
    sampler: TrajectorySampler,
    t_s: float,
    at_rest: MotionSample,
    joint: int,
    period_s: float,
) -> StopProfile | None:
    """Go back along a path, to where a joint has least to give.

    Args:
        robot: How it stands.
        sampler: The path.
        t_s: Its time when the brake began.
        at_rest: Where the brake ended.
        joint: The joint's index among those of ``q[7:]``.
        period_s: Control period.

    Returns:
        None when that would not ease the joint, or the robot rests beside the path.
    """
    begin_s = _time_at(sampler, t_s, at_rest, period_s)
    if begin_s is None:
        return None
    dynamics = StandingDynamics(robot)
    carried = {
        back_s: abs(float(dynamics.holding_efforts(sampler.at(begin_s - back_s).q)[joint]))
        for back_s in (*(back_s for back_s in _BACK_S if back_s < begin_s), begin_s)
        if back_s <= _BACK_S[-1]
    }
    now = abs(float(dynamics.holding_efforts(at_rest.q)[joint]))
    back_s = min(carried, key=carried.__getitem__, default=0.0)
    if not carried or carried[back_s] > _EASED * now:
        return None
    duration_s = back_s * PEAK / _RATE
    u = np.minimum(1.0, np.arange(1, round(duration_s / period_s) + 2) * period_s / duration_s)
    share, rate, slope = rest_to_rest(u, duration_s)
    rows = sampler.many(begin_s - back_s * share, -back_s * rate, -back_s * slope)
    # where it rests is a hair beside the path: that is kept on all the way
    rows.q[:, 7:] += at_rest.q[7:] - sampler.at(begin_s).q[7:]
    return StopProfile(resting_on_the_stance(robot, rows, period_s))


def _time_at(sampler: TrajectorySampler, t_s: float, at_rest: MotionSample, period_s: float) -> float | None:
    """The path's time where a brake that began at ``t_s`` ended; None beside the path."""
    ends_s = min(t_s + _BRAKED_WITHIN_S, sampler.duration_s)
    times: NDArray[np.float64] = np.arange(t_s, ends_s, period_s, dtype=np.float64)
    if not len(times):
        return None
    beside = np.abs(sampler.many(times).q[:, 7:] - at_rest.q[7:]).max(axis=1)
    nearest = int(np.argmin(beside))
    return float(times[nearest]) if beside[nearest] <= _STRAYED_RAD else None
