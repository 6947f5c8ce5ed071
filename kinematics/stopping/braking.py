"""How to come to rest within acceleration and jerk limits: along a path, or joint by joint."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pinocchio as pin
import ruckig

from kinematics.arrays import Array
from kinematics.dynamics.zmp import zmp_margins_m
from kinematics.errors import InvalidMotionError
from kinematics.model.robot_model import RobotModel
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.sampler import MotionSample, TrajectorySampler
from kinematics.motion.verdict import SETPOINT_FRACTION
from kinematics.standing.free_coordinates import FreeCoordinates, free_coordinates

_FASTEST_BRAKE_1_S2 = 40.0
"""Largest slope of the rate: from full speed to rest in 25 ms, sooner than any joint could follow."""
_SHARES = (1.0, 0.75, 0.55, 0.4, 0.28, 0.18, 0.1)
"""Shares of the hardest slope and of its hardest change that are tried, the quickest pair first."""
_HEAVY_SHARES = (*_SHARES, 0.07, 0.05)
"""The same for base and trunk, which the legs have to follow."""
_GENTLE_S = (0.22, 0.32)
"""Arms that stop within less than about a period of the standing robot's sway (0.3 s) leave it swaying:
stopped in 0.13 s from 1.3 rad/s, ankles and knees moved by 0.03 rad/s after half a second still."""
_MOVING_RAD_S = 1e-9
_STANDING_RAD = 1e-4
"""Legs nearer than this to where base and stance put them keep the stance: between the samples of a
trajectory they stray by 1e-5 rad."""
_PROBE_S = 1e-3
_BASE_ACCELERATION = np.array([1.5, 1.5, 1.5, 4.0, 4.0, 4.0])
_BASE_JERK = np.array([20.0, 20.0, 20.0, 50.0, 50.0, 50.0])
"""Of the base while it is braked, m/s^2, rad/s^2, and their rates: as much as the legs can follow."""
_ZMP_RESERVE_M = 0.005
_ROOM = 1.0 + SETPOINT_FRACTION
"""The path that is being braked may use its limits fully already."""
_LOOKS: Array = np.linspace(0.0, 1.0, 17)[1:].astype(np.float64)
"""Shares of a brake's time at which the ZMP is computed, and where a brake is looked at coarsely."""
_AHEAD = 33
"""Instants of the path ahead that stand for it in a coarse look."""
_LATEST_S = 0.5
"""A robot that stops has to be at rest by then."""
_TRIED = 4
_MORE_GENTLE, _LESS_STEEP = 1.15, 1.1
"""So many brakes are computed at most, each gentler by this than one that tips, or that steps: a stop has to
begin within a control period."""


@dataclass(frozen=True, slots=True)
class Brake:
    """A motion that comes to rest along the path that the robot was on.

    Attributes:
        rows: Configuration, velocity and acceleration at each period, the last at rest.
        steps: Whether it passes a jerk limit where the acceleration of the path itself jumps, because no
            brake that keeps the limit comes to rest in time.
    """

    rows: MotionSample
    steps: bool


def brake_along(
    robot: StandingRobot, sampler: TrajectorySampler, t_s: float, period_s: float
) -> Brake | None:
    """Slow a trajectory down to rest without leaving its path.

    The time along the trajectory passes at a rate that falls from 1 to 0. Of the profiles whose joint
    accelerations and jerks keep to the limits, and that do not tip the robot, the quickest gentle one is
    taken, see ``_GENTLE_S``; else the gentlest of the harder ones, else the quickest of the slower ones.

    Args:
        robot: Where it stands.
        sampler: The trajectory.
        t_s: Where along it the braking begins.
        period_s: Time between two rows of the answer.

    Returns:
        A brake whose first row is one period after the beginning; None when no profile holds the limits
        before the trajectory ends, so that it is best played out.
    """
    acceleration, jerk = robot.model.acceleration, robot.model.jerk
    here = sampler.at(t_s)
    speed = np.maximum(np.abs(here.v[6:]), _MOVING_RAD_S)
    hardest = min(_FASTEST_BRAKE_1_S2, float(np.min(acceleration / speed)))
    hardest_jerk = float(np.min(jerk / speed))
    pairs = [(a * hardest, j * hardest_jerk) for a in _SHARES for j in _SHARES]
    # A brake takes half its time of the path.
    fitting = [pair for pair in pairs if t_s + 0.5 * _brake_time_s(pair) <= sampler.duration_s]
    before = sampler.at(max(t_s - period_s, 0.0)).v[6:]
    tried, tipping_s, stepping_s = 0, 0.0, 0.0
    spare: Brake | None = None
    for limits in _within(sorted(fitting, key=_preference), sampler, t_s, acceleration, jerk):
        time_s = _brake_time_s(limits)
        if time_s < max(_MORE_GENTLE * tipping_s, _LESS_STEEP * stepping_s):
            continue  # hardly gentler than one that tips, or jerks where the path's acceleration steps
        if spare is not None and time_s > _LATEST_S:
            break  # to be at rest in time is worth more than a step of the path's own
        tried += 1
        if tried > _TRIED:
            break
        look_s = time_s * _LOOKS
        if not stays_upright(robot, _braked(sampler, t_s, limits, look_s)):
            tipping_s = max(tipping_s, time_s)
            continue
        periods = max(1, int(np.ceil(time_s / period_s - 1e-9)))
        motion = _braked(sampler, t_s, limits, period_s * np.arange(1, periods + 1, dtype=np.float64))
        if not keeps_limits(motion.a[:, 6:], here.a[6:], acceleration, jerk, period_s):
            continue
        if keeps_jerk(np.vstack([before, here.v[6:], motion.v[:, 6:]]), jerk, period_s):
            return Brake(motion, steps=False)
        spare, stepping_s = (Brake(motion, steps=True), time_s) if spare is None else (spare, time_s)
    return spare


def _braked(sampler: TrajectorySampler, t_s: float, limits: tuple[float, float], at_s: Array) -> MotionSample:
    """What a brake that begins at ``t_s`` makes of a trajectory, at times since then, shape (k,)."""
    passed, rate, slope = _brake_rate(*limits, _brake_time_s(limits), at_s)
    motion = sampler.many(t_s + passed, rate, slope)
    if at_s[-1] >= _brake_time_s(limits):
        motion.v[-1], motion.a[-1] = 0.0, 0.0
    return motion


def _within(
    pairs: list[tuple[float, float]], sampler: TrajectorySampler, t_s: float, acceleration: Array, jerk: Array
) -> list[tuple[float, float]]:
    """Leave out, all at once, the pairs that exceed a limit already where they are looked at coarsely."""
    if not pairs:
        return []
    times = np.array([_brake_time_s(pair) for pair in pairs])
    ahead_s = np.linspace(0.0, 0.5 * float(times.max()), _AHEAD)
    ahead = sampler.many(t_s + ahead_s)
    moves = np.flatnonzero(np.abs(ahead.v[:, 6:]).max(axis=0) > _MOVING_RAD_S)
    if len(moves) == 0:
        return pairs
    # In shares of the limits, whatever moves.
    v, a = ahead.v[:, 6 + moves], ahead.a[:, 6 + moves]
    bend = np.gradient(a, ahead_s[1], axis=0)
    limits = np.array(pairs)
    at_s = times[:, None] * np.concatenate([[0.0], _LOOKS])
    hardest, hardest_jerk, time_s = limits[:, :1], limits[:, 1:], times[:, None]
    passed, rate, slope = _brake_rate(hardest, hardest_jerk, time_s, at_s)
    bending_s = np.minimum(hardest / hardest_jerk, 0.5 * time_s)
    change = hardest_jerk * ((at_s >= time_s - bending_s) * 1.0 - (at_s <= bending_s))
    k = np.minimum(np.rint(passed / ahead_s[1]), _AHEAD - 1).astype(np.intp)
    rate, slope, change = rate[..., None], slope[..., None], change[..., None]
    accelerations = rate**2 * a[k] + slope * v[k]
    jerks = rate**3 * bend[k] + 3.0 * rate * slope * a[k] + change * v[k]
    most, most_jerk = acceleration[moves] * _ROOM, jerk[moves] * _ROOM
    fits = (np.abs(accelerations) <= most).all(axis=(1, 2)) & (np.abs(jerks) <= most_jerk).all(axis=(1, 2))
    return [pair for pair, fit in zip(pairs, fits.tolist(), strict=True) if fit]


def stays_upright(robot: StandingRobot, motion: MotionSample) -> bool:
    """Whether a motion keeps the ZMP inside the support polygon."""
    return bool(zmp_margins_m(robot, motion).min() >= _ZMP_RESERVE_M)


def keeps_limits(a: Array, start: Array, acceleration: Array, jerk: Array, period_s: float) -> bool:
    """Whether accelerations, one row a period after ``start``, keep their limits and those of the jerk."""
    if np.any(np.abs(a) > acceleration * _ROOM):
        return False
    change = np.diff(np.vstack([start, a]), axis=0) / period_s
    return not np.any(np.abs(change) > jerk * _ROOM)


def keeps_jerk(v: Array, jerk: Array, period_s: float) -> bool:
    """Whether speeds, one row a period, keep the jerk limits as differences of the setpoints show them.

    A trajectory's acceleration steps at its samples. Such a step lies between other instants here than in the
    accelerations, and the jerk on its other side with it.
    """
    return not np.any(np.abs(np.diff(v, 2, axis=0)) > jerk * _ROOM * period_s**2)


def _brake_time_s(limits: tuple[float, float]) -> float:
    """Time in which a rate of 1 falls to 0 with a limited slope and a limited change of it."""
    slope, jerk = limits
    if slope * slope >= jerk:
        return 2.0 / float(np.sqrt(jerk))
    return 1.0 / slope + slope / jerk


def _preference(limits: tuple[float, float]) -> tuple[int, float]:
    """Sorts profiles, the best first."""
    time_s = _brake_time_s(limits)
    if time_s < _GENTLE_S[0]:
        return 1, -time_s
    return (0 if time_s <= _GENTLE_S[1] else 2), time_s


def _brake_rate(
    slope_limit: float | Array, jerk_limit: float | Array, time_s: float | Array, at_s: Array
) -> tuple[Array, Array, Array]:
    """Time passed, rate and its slope while the rate falls from 1 to 0 within ``time_s``.

    The slope falls, stays and rises again; its change is limited, and so is it itself.

    Args:
        slope_limit, jerk_limit, time_s: Of one brake, or of many, shape (n, 1).
        at_s: Times since the beginning, shape (k,) or (n, k).
    """
    bend_s = np.minimum(slope_limit / jerk_limit, 0.5 * time_s)
    deepest = jerk_limit * bend_s
    at_s = np.minimum(at_s, time_s)
    early, late = np.minimum(at_s, bend_s), np.maximum(at_s - (time_s - bend_s), 0.0)
    straight = np.minimum(np.maximum(at_s - bend_s, 0.0), time_s - 2.0 * bend_s)
    slope = -jerk_limit * (early - late)
    rate = 1.0 - 0.5 * jerk_limit * early**2
    passed = early - jerk_limit * early**3 / 6.0
    passed += rate * straight - 0.5 * deepest * straight**2
    rate = rate - deepest * straight
    passed += rate * late - 0.5 * deepest * late**2 + jerk_limit * late**3 / 6.0
    rate = rate - deepest * late + 0.5 * jerk_limit * late**2
    return passed, rate, slope


def brake_joints(
    q: Array, v: Array, a: Array, acceleration: Array, jerk: Array, period_s: float
) -> tuple[Array, Array, Array]:
    """Bring joints to rest, each on its own, within limits.

    Args:
        q, v, a: Where they are and how they move, shape (n,).
        acceleration, jerk: Limits, shape (n,); an acceleration beyond its limit is cut to it.
        period_s: Time between two rows of the answer.

    Returns:
        Positions, velocities and accelerations, one row a period, the first at one period after
        the beginning, the last at rest; shape (k, n) each.
    """
    request = ruckig.InputParameter(len(q))
    request.control_interface = ruckig.ControlInterface.Velocity
    request.synchronization = ruckig.Synchronization.No
    request.current_position, request.current_velocity = q, v
    request.current_acceleration = np.clip(a, -acceleration, acceleration)
    request.target_velocity = request.target_acceleration = np.zeros(len(q))
    request.max_acceleration, request.max_jerk = acceleration, jerk
    rows = _rows(request, len(q), period_s)
    return rows[:, 0], rows[:, 1], rows[:, 2]


def brake_standing(robot: StandingRobot, now: MotionSample, period_s: float) -> MotionSample | None:
    """Bring a standing robot to rest at once, without moving its feet.

    Arms and head brake each on their own. Base and trunk, which are heavy, go straight on while they
    slow down, as quickly as the robot can without tipping; the legs follow from the base.

    Args:
        robot: Where it stands.
        now: What it is commanded now.
        period_s: Time between two rows of the answer.

    Returns:
        One row a period, the first at one period after ``now``, the last at rest; None when its feet
        are not where the stance says, or no profile keeps the legs within their limits.
    """
    model, space = robot.model, free_coordinates(robot)
    x = space.from_q(now.q)
    q, reached = space.to_q(x[None, :])
    gap = now.q[7:] - q[0, 7:]
    if not reached[0] or np.abs(gap).max() > _STANDING_RAD:
        return None
    speed, bend = _rates(model, space, now)
    base, trunk = space.base_size, [space.index(joint) for joint in model.description.groups["torso"]]
    limits = model.acceleration[model.indices(space.joints)], model.jerk[model.indices(space.joints)]
    for share in _HEAVY_SHARES:
        # The heavy parts brake gently, but may go on with what they do now.
        acceleration = np.concatenate([_BASE_ACCELERATION[:base], limits[0]])
        jerk = np.concatenate([_BASE_JERK[:base], limits[1]])
        for heavy in (*range(base), *trunk):
            acceleration[heavy] = max(share * acceleration[heavy], abs(bend[heavy]))
            jerk[heavy] *= share
        rows = brake_joints(x, speed, bend, acceleration, jerk, period_s)[0]
        q, reached = space.to_q(rows)
        if not reached.all() or (share < _SHARES[-1] and len(q) * period_s > _LATEST_S):
            return None
        q[:, 7:] += gap * np.linspace(1.0, 0.0, len(q) + 1)[1:, None]
        motion = _sampled(model, now, q, period_s)
        rows_seen = np.unique((len(q) * _LOOKS - 0.5).astype(np.intp))
        seen = MotionSample(motion.q[rows_seen], motion.v[rows_seen], motion.a[rows_seen])
        if keeps_limits(
            motion.a[:, 6:], now.a[6:], model.acceleration, model.jerk, period_s
        ) and stays_upright(robot, seen):
            return motion
    return None


def _rates(model: RobotModel, space: FreeCoordinates, now: MotionSample) -> tuple[Array, Array]:
    """How fast the free coordinates change, and how fast that changes."""
    h = _PROBE_S
    before, here, after = (
        space.from_q(pin.integrate(model.pin, now.q, t * now.v + 0.5 * t * t * now.a)) for t in (-h, 0.0, h)
    )
    return (after - before) / (2.0 * h), (after - 2.0 * here + before) / (h * h)


def _sampled(model: RobotModel, now: MotionSample, q: Array, period_s: float) -> MotionSample:
    """Velocities and accelerations of configurations that follow ``now``; the last one at rest."""
    around = np.vstack([now.q, q, q[-1:]])
    v = np.array([pin.difference(model.pin, around[k], around[k + 2]) for k in range(len(q))]) / (
        2.0 * period_s
    )
    v[-1] = 0.0
    return MotionSample(q, v, np.diff(np.vstack([now.v, v]), axis=0) / period_s)


def _rows(request: ruckig.InputParameter, joints: int, period_s: float) -> Array:
    """Sample the profile that solves a request: shape (k, 3, joints), the last row exactly at rest."""
    profile = ruckig.Trajectory(joints)
    result = ruckig.Ruckig(joints).calculate(request, profile)
    if result not in (ruckig.Result.Working, ruckig.Result.Finished):
        raise InvalidMotionError(f"no profile brings the motion to rest: {result}")
    periods = max(1, int(np.ceil(profile.duration / period_s - 1e-9)))
    rows = np.array([profile.at_time(min(k * period_s, profile.duration)) for k in range(1, periods + 1)])
    rows[-1, 1:] = 0.0
    return rows
