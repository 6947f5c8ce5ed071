"""How a trajectory that was braked along its path goes on from there."""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.sampler import MotionSample, TrajectorySampler
from kinematics.motion.trajectory import Trajectory
from kinematics.stopping.braking import keeps_limits, stays_upright

_GATHER_S = (0.3, 0.45, 0.7, 1.0, 1.5, 2.5)
"""Times in which speed is gathered, the quickest first; brakes take as long, see
``kinematics.stopping.braking``.
"""
_RATES = (1.0, 0.5, 0.25, 0.1)
"""Shares of the speed that was planned; less than all of it only where hardly any way is left."""
_SHORT_S = 0.6
"""What would take less than this at full speed may be gone more slowly."""
_STEP_S = 0.004
_SEARCH_S = 1e-4
_NEWTON = 3
"""Steps from the nearest of the instants that were looked at to the nearest of all."""
_LOOK_EVERY = 5
_KNOTS_S = 1e-3
"""Knots nearer than this are one."""
_END_S = 0.02
_CLOSE_S = 0.1
"""From so shortly before the end it is a fraction of a milliradian, gone from rest to rest in this time."""


def rest_of(
    robot: StandingRobot, trajectory: Trajectory, q: Array, near_s: float, period_s: float
) -> Trajectory | None:
    """What is left of a trajectory, from rest, along the same path.

    The time along the path passes at a rate that rises from 0, as a cubic with level ends, to the full one;
    from then on the samples are the trajectory's own.

    Args:
        robot: Where it stands.
        trajectory: The whole motion.
        q: Where it rests, on its path up to the legs' straying between samples, shape (nq,).
        near_s: Where along the trajectory it rests, to two control periods.
        period_s: The control period, for which limits are held.

    Returns:
        The rest, beginning within micrometres of ``q``, at rest; None when no way of gathering speed keeps
        the limits of acceleration, jerk and balance.
    """
    model, sampler = robot.model, TrajectorySampler(trajectory)
    t0 = _nearest_s(sampler, q, near_s, 2.0 * period_s)
    left_s = sampler.duration_s - t0
    if left_s <= _END_S:
        ends = sampler.many(np.array([t0, sampler.duration_s]))
        close_s = np.array([0.0, _CLOSE_S])
        return Trajectory(trajectory.joints, trajectory.stance, close_s, ends.q, np.zeros_like(ends.v))
    for rate in _RATES if left_s < _SHORT_S else _RATES[:1]:
        for gather_s in _GATHER_S:
            if 0.5 * rate * gather_s > left_s:
                continue
            at_s: Array = np.arange(period_s, gather_s, period_s, dtype=np.float64)
            rows = _gathered(sampler, t0, rate, gather_s, at_s)
            seen = MotionSample(rows.q[::_LOOK_EVERY], rows.v[::_LOOK_EVERY], rows.a[::_LOOK_EVERY])
            rest = np.zeros(len(model.joints))
            held = keeps_limits(rows.a[:, 6:], rest, model.acceleration, model.jerk, period_s)
            if held and stays_upright(robot, seen):
                return _joined(trajectory, sampler, t0, rate, gather_s)
    return None


def _nearest_s(sampler: TrajectorySampler, q: Array, near_s: float, within_s: float) -> float:
    """Time along the path of the place nearest to a configuration, about a time."""
    steps = np.arange(-within_s, within_s + 0.5 * _SEARCH_S, _SEARCH_S, dtype=np.float64)
    window_s: Array = np.clip(near_s + steps, 0.0, sampler.duration_s)
    off = np.abs(sampler.many(window_s).q[:, 7:] - q[7:]).max(axis=1)
    t = float(window_s[int(np.argmin(off))])
    for _ in range(_NEWTON):
        there = sampler.at(t)
        speed = there.v[6:]
        if not speed.any():
            break
        step_s = float((q[7:] - there.q[7:]) @ speed / (speed @ speed))
        t = float(np.clip(t + np.clip(step_s, -_SEARCH_S, _SEARCH_S), 0.0, sampler.duration_s))
    return t


def _gathered(
    sampler: TrajectorySampler, t0: float, rate: float, gather_s: float, at_s: Array
) -> MotionSample:
    u = np.minimum(at_s / gather_s, 1.0)
    passed = rate * gather_s * (u**3 - 0.5 * u**4)
    return sampler.many(t0 + passed, rate * (3.0 * u**2 - 2.0 * u**3), rate * 6.0 * u * (1.0 - u) / gather_s)


def _joined(
    trajectory: Trajectory, sampler: TrajectorySampler, t0: float, rate: float, gather_s: float
) -> Trajectory:
    """Samples while speed is gathered, then those of the trajectory itself, later."""
    steps = max(2, round(gather_s / _STEP_S))
    at_s: Array = np.linspace(0.0, gather_s, steps + 1, dtype=np.float64)
    rows = _gathered(sampler, t0, rate, gather_s, at_s)
    reached_s = t0 + 0.5 * rate * gather_s
    later = trajectory.t_s > reached_s + _KNOTS_S
    t = np.concatenate([at_s, gather_s + (trajectory.t_s[later] - reached_s) / rate])
    q = np.vstack([rows.q, trajectory.q[later]])
    v = np.vstack([rows.v, rate * trajectory.v[later]])
    v[0] = v[-1] = 0.0
    return Trajectory(trajectory.joints, trajectory.stance, t, q, v)
