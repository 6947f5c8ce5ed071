"""How to come to rest within acceleration and jerk limits: along a path, or joint by joint."""

from __future__ import annotations

import numpy as np
import pinocchio as pin
import ruckig
from numpy.typing import NDArray

from kinematics.check_settings import DEFAULT_SETTINGS
from kinematics.errors import InvalidMotionError
from kinematics.free_coordinates import FreeCoordinates
from kinematics.robot_model import RobotModel
from kinematics.trajectory import Stance
from kinematics.trajectory_sampler import MotionSample, TrajectorySampler
from kinematics.zmp import balance_margins_m

Array = NDArray[np.float64]

_FASTEST_BRAKE_1_S2 = 40.0
"""Largest slope of the rate: from full speed to rest in 25 ms, sooner than any joint could follow."""
_SHARES = (1.0, 0.75, 0.55, 0.4, 0.28, 0.18, 0.1)
"""Shares of the hardest slope and of its hardest change that are tried, the quickest pair first."""
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
_JUDGED_ROWS = 5
"""Every so many rows of a stop the ZMP is computed."""


def brake_along(
    model: RobotModel, stance: Stance, sampler: TrajectorySampler, t_s: float, period_s: float
) -> MotionSample | None:
    """Slow a trajectory down to rest without leaving its path.

    The time along the trajectory passes at a rate that falls from 1 to 0. Of the profiles whose joint
    accelerations and jerks keep to the limits, and that do not tip the robot, the quickest gentle one is
    taken, see ``_GENTLE_S``; else the gentlest of the harder ones, else the quickest of the slower ones.

    Args:
        model: The robot.
        stance: Where it stands.
        sampler: The trajectory.
        t_s: Where along it the braking begins.
        period_s: Time between two rows of the answer.

    Returns:
        One row a period, the first at one period after the beginning, the last at rest; None when
        no profile holds the limits before the trajectory ends, so that it is best played out.
    """
    acceleration, jerk = model.acceleration, model.jerk
    here = sampler.at(t_s)
    speed = np.maximum(np.abs(here.v[6:]), _MOVING_RAD_S)
    hardest = min(_FASTEST_BRAKE_1_S2, float(np.min(acceleration / speed)))
    hardest_jerk = float(np.min(jerk / speed))
    pairs = [(a * hardest, j * hardest_jerk) for a in _SHARES for j in _SHARES]
    for slope_limit, jerk_limit in sorted(pairs, key=_preference):
        if t_s + 0.5 * _brake_time_s((slope_limit, jerk_limit)) > sampler.duration_s:
            continue  # a brake takes half its time of the path
        passed, rate, slope = _brake_rate(slope_limit, jerk_limit, period_s)
        if t_s + passed[-1] > sampler.duration_s:
            continue
        motion = sampler.many(t_s + passed, rate, slope)
        if _holds(motion.a[:, 6:], here.a[6:], acceleration, jerk, period_s) and _stands(
            model, stance, motion
        ):
            return motion
    return None


def _stands(model: RobotModel, stance: Stance, motion: MotionSample) -> bool:
    """Whether a stop keeps the ZMP inside the support polygon."""
    rows = MotionSample(motion.q[::_JUDGED_ROWS], motion.v[::_JUDGED_ROWS], motion.a[::_JUDGED_ROWS])
    return bool(balance_margins_m(model, stance, rows)[0].min() >= _ZMP_RESERVE_M)


def _holds(a: Array, start: Array, acceleration: Array, jerk: Array, period_s: float) -> bool:
    # As much room as the checker gives: the path that is being braked may use it already.
    if np.any(np.abs(a) > acceleration * (1.0 + DEFAULT_SETTINGS.acceleration_fraction)):
        return False
    change = np.diff(np.vstack([start, a]), axis=0) / period_s
    return not np.any(np.abs(change) > jerk * (1.0 + DEFAULT_SETTINGS.jerk_fraction))


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


def _brake_rate(slope_limit: float, jerk_limit: float, period_s: float) -> tuple[Array, Array, Array]:
    """Time passed, rate and its slope for each period while the rate falls from 1 to 0."""
    request = ruckig.InputParameter(1)
    request.control_interface = ruckig.ControlInterface.Velocity
    request.current_position = request.current_acceleration = [0.0]
    request.current_velocity = [1.0]
    request.target_velocity = request.target_acceleration = [0.0]
    request.max_acceleration, request.max_jerk = [slope_limit], [jerk_limit]
    rows = _rows(request, 1, period_s)
    return rows[:, 0, 0], rows[:, 1, 0], rows[:, 2, 0]


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


def brake_standing(
    model: RobotModel, stance: Stance, space: FreeCoordinates, now: MotionSample, period_s: float
) -> MotionSample | None:
    """Bring a standing robot to rest at once, without moving its feet.

    Arms and head brake each on their own. Base and trunk, which are heavy, go straight on while they
    slow down, as quickly as the robot can without tipping; the legs follow from the base.

    Args:
        model: The robot.
        stance: Where it stands.
        space: Its free coordinates on that stance.
        now: What it is commanded now.
        period_s: Time between two rows of the answer.

    Returns:
        One row a period, the first at one period after ``now``, the last at rest; None when its feet
        are not where the stance says, or no profile keeps the legs within their limits.
    """
    x = space.from_q(now.q)
    q, reached = space.to_q(x[None, :])
    gap = now.q[7:] - q[0, 7:]
    if not reached[0] or np.abs(gap).max() > _STANDING_RAD:
        return None
    speed, bend = _rates(model, space, now)
    base, trunk = space.base_size, [space.index(joint) for joint in model.description.groups["torso"]]
    limits = model.acceleration[model.indices(space.joints)], model.jerk[model.indices(space.joints)]
    for share in _SHARES:
        # The heavy parts brake gently, but may go on with what they do now.
        acceleration = np.concatenate([_BASE_ACCELERATION[:base], limits[0]])
        jerk = np.concatenate([_BASE_JERK[:base], limits[1]])
        for heavy in (*range(base), *trunk):
            acceleration[heavy] = max(share * acceleration[heavy], abs(bend[heavy]))
            jerk[heavy] *= share
        rows = brake_joints(x, speed, bend, acceleration, jerk, period_s)[0]
        q, reached = space.to_q(rows)
        if not reached.all():
            return None
        q[:, 7:] += gap * np.linspace(1.0, 0.0, len(q) + 1)[1:, None]
        motion = _sampled(model, now, q, period_s)
        if _holds(motion.a[:, 6:], now.a[6:], model.acceleration, model.jerk, period_s) and _stands(
            model, stance, motion
        ):
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
