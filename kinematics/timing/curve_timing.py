"""Give a curve its time: the fastest motion that keeps every joint's limits, made smooth.

First the least time under the limits of velocity and acceleration, which vary along the curve. Then the
motion is averaged over a window of time, all coordinates alike: averages of velocities and of
accelerations keep limits that held before, the acceleration can change by no more than twice its limit
over the window, which bounds the jerk, straight pieces stay straight, and the whole takes one window
longer, however many corners there are. A bend is cut by a little, which is bounded. What follows from
the coordinates in other ways, the legs, is judged afterwards, and the curve is run more slowly where
they need it, until everything holds for the cubics between the samples.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array, Sealed, as_float64
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.curves import Curve
from kinematics.motion.sampler import cross
from kinematics.motion.trajectory import Trajectory
from kinematics.standing.free_coordinates import free_coordinates
from kinematics.timing.curve_speed import CurveGrid
from kinematics.timing.timing_kernel import excess, grid_times, running_mean

# A motion may stray this far from its curve, in weighted coordinates (radians of a joint), each.
FOLLOWING = 0.007
# Longest distance of the samples; the motion between them is the cubic of their positions and velocities.
SAMPLE_S = 0.01
# The shortest window, in samples: cubics must not overshoot what happens between the samples by much.
LEAST_WINDOW = 6.0
# How often a motion may be judged and slowed down: locally at first, then everywhere.
LOCAL_ROUNDS = 8
ROUNDS = 40
# A factor within this of 1 is rounding.
TOLERANCE = 2e-6
# Step in time of central differences along the motion.
STEP_S = 1e-4
# A pelvis that moves by less than this, m and rad, rests.
STILL = 1e-9


@dataclass(frozen=True, slots=True)
class Pace:
    """How fast a motion may be: shares of the velocity, acceleration and jerk limits.

    The jerk's is less than 1 by default: a brake along the path adds its own jerk to the motion's.
    """

    velocity: float = 1.0
    acceleration: float = 1.0
    jerk: float = 0.8


@dataclass(frozen=True, slots=True)
class JointLimits(Sealed):
    """What each of k joints may do, shape (k,) each, SI units."""

    velocity: Array
    acceleration: Array
    jerk: Array

    def at(self, pace: Pace) -> JointLimits:
        """The share of the limits that a pace uses."""
        return JointLimits(
            self.velocity * pace.velocity, self.acceleration * pace.acceleration, self.jerk * pace.jerk
        )


@dataclass(frozen=True, slots=True)
class TimedCurve(Sealed):
    """Samples of the motion along a curve.

    Attributes:
        t_s: Times, evenly spaced from 0, shape (n,).
        q, rate: Configurations and their derivatives, shape (n, nq).
    """

    t_s: Array
    q: Array
    rate: Array


Configurations = Callable[[Array], Array | None]
"""Maps coordinates, shape (n, size), to configurations, shape (n, nq), or None when one has none."""

Moving = Callable[[Array, Array], tuple[Array, Array] | None]
"""Maps coordinates and their velocities, shape (n, size) each, to configurations and their derivatives."""


class CurveTimer:
    """Gives one curve its time, at as many paces as are asked for."""

    def __init__(self, robot: StandingRobot, curve: Curve) -> None:
        self._robot, self._space = robot, free_coordinates(robot)
        self._standing = _Standing(robot)
        self._placed = placed_curve(curve, self._standing.configurations)

    def at(self, pace: Pace) -> Trajectory | None:
        """Make the trajectory that runs the curve from rest to rest within all limits.

        Between its ends it may leave the curve by ``FOLLOWING``, where the curve bends.

        Returns:
            The trajectory, or None when the legs cannot follow somewhere on the curve.
        """
        model = self._robot.model
        if self._placed is None:
            return None
        limits = JointLimits(model.velocity, model.acceleration, model.jerk).at(pace)
        timed = _timed(self._placed, self._standing.moving, limits, self._space.weights)
        if timed is None:
            return None
        v = _velocity(timed.q, timed.rate)
        return Trajectory(joints=model.joints, stance=self._robot.stance, t_s=timed.t_s, q=timed.q, v=v)


def time_curve(robot: StandingRobot, curve: Curve, pace: Pace) -> Trajectory | None:
    """The trajectory of one curve at one pace; see ``CurveTimer``."""
    return CurveTimer(robot, curve).at(pace)


def time_coordinates(
    curve: Curve, configurations: Configurations, limits: JointLimits, weights: Array
) -> TimedCurve | None:
    """Run a curve from rest to rest in the least time that stays smooth, for any robot.

    Args:
        curve: Through coordinates of the robot.
        configurations: What they mean. The last columns are the joints that ``limits`` holds.
        limits: Of the joints.
        weights: Of the coordinates where ``FOLLOWING`` is measured, shape (size,).

    Returns:
        The motion, or None when a point has no configuration, or limits cannot be held at any speed.
    """
    placed = placed_curve(curve, configurations)
    moving = functools.partial(_differences, configurations)
    return None if placed is None else _timed(placed, moving, limits, weights)


def placed_curve(curve: Curve, configurations: Configurations) -> tuple[CurveGrid, Array] | None:
    """A curve's grid and the configurations there, or None when a point has none."""
    grid = CurveGrid.along(curve)
    q = configurations(grid.points)
    return None if q is None else (grid, as_float64(q, (len(grid.points), None), "configurations"))


def _timed(
    placed: tuple[CurveGrid, Array], moving: Moving, limits: JointLimits, weights: Array
) -> TimedCurve | None:
    """``time_coordinates`` of a curve whose configurations are known."""
    grid, q = placed
    k = len(limits.velocity)
    weights = as_float64(weights, (grid.points.shape[1],), "weights")
    most = [as_float64(array) for array in (limits.velocity, limits.acceleration, limits.jerk)]
    window_s = max(float(np.max(2.0 * limits.acceleration / limits.jerk)), LEAST_WINDOW * SAMPLE_S)
    # a cubic between samples overshoots what comes to rest at a limit there: accelerations by up to 8/27
    # of jerk times spacing (see CheckSettings), speeds by less than this
    jerk = 2.0 * limits.acceleration / window_s
    acceleration = limits.acceleration - 8.0 / 27.0 * jerk * SAMPLE_S
    velocity = np.maximum(limits.velocity - jerk * SAMPLE_S**2 / 16.0, 0.9 * limits.velocity)
    slowed = grid.bounded(q[:, -k:], velocity, acceleration)
    for attempt in range(ROUNDS):
        rates = slowed.rates()
        times = grid_times(rates, grid.step)
        count = int(np.ceil((times[-1] + window_s) / SAMPLE_S)) + 1
        x, v, stray = running_mean(grid.points, grid.step, rates, times, window_s, count, weights, FOLLOWING)
        t_s = np.linspace(0.0, times[-1] + window_s, count)
        x[0], x[-1], v[0], v[-1] = grid.points[0], grid.points[-1], 0.0, 0.0
        motion = moving(x, v)
        if motion is None:
            return None
        q, rate = motion
        joints, speeds = as_float64(q[:, -k:]), as_float64(rate[:, -k:])
        factor = excess(joints, speeds, t_s[1], *most)
        far = stray / FOLLOWING
        if max(factor.max(), far.max()) <= 1.0 + TOLERANCE:
            return TimedCurve(t_s, q, rate)
        if attempt >= LOCAL_ROUNDS:
            factor[:] = max(factor.max(), far.max())
        slowed.slow_down(factor, far, t_s, times, window_s, rates)
    return None


def _differences(configurations: Configurations, x: Array, v: Array) -> tuple[Array, Array] | None:
    """``Moving`` of any robot."""
    beside = configurations(np.concatenate([x, x + STEP_S * v, x - STEP_S * v]))
    if beside is None:
        return None
    q, ahead, behind = as_float64(beside, (3 * len(x), None), "configurations").reshape(3, len(x), -1)
    return q, (ahead - behind) / (2.0 * STEP_S)


class _Standing:
    """Configurations of a robot on its feet or its mount; while the pelvis rests, so do the legs."""

    def __init__(self, robot: StandingRobot) -> None:
        self._space = free_coordinates(robot)
        self._columns = 7 + robot.model.indices(self._space.joints)
        self._base = self._space.base_size

    def configurations(self, x: Array) -> Array | None:
        """``Configurations`` of this robot."""
        if not self._pelvis_rests(x):
            q, reached = self._space.to_q(x)
            return q if reached.all() else None
        first, reached = self._space.to_q(x[:1])
        q = np.repeat(first, len(x), axis=0)
        q[:, self._columns] = x[:, self._base :]
        return q if reached.all() else None

    def moving(self, x: Array, v: Array) -> tuple[Array, Array] | None:
        """``Moving`` of this robot."""
        if not self._pelvis_rests(x):
            return _differences(self.configurations, x, v)
        q = self.configurations(x)
        if q is None:
            return None
        rate = np.zeros_like(q)
        rate[:, self._columns] = v[:, self._base :]
        return q, rate

    def _pelvis_rests(self, x: Array) -> bool:
        return bool(np.ptp(x[:, : self._base], axis=0).max(initial=0.0) <= STILL)


def _velocity(q: Array, slope: Array) -> Array:
    """Velocities in Pinocchio's convention from the derivative of ``q``, shapes (n, nq) to (n, nv)."""
    v = np.empty((len(q), q.shape[1] - 1))
    v[:, 6:] = slope[:, 7:]
    if not slope[:, :7].any():
        v[:, :6] = 0.0
        return v
    xyz, w = q[:, 3:6], q[:, 6:7]
    d_xyz, d_w = slope[:, 3:6], slope[:, 6:7]
    # local angular velocity 2 * conj(quaternion) * derivative
    v[:, 3:6] = 2.0 * (w * d_xyz - d_w * xyz - cross(xyz, d_xyz))
    # linear velocity turned into the base's frame: rotate by the conjugate
    linear = slope[:, :3]
    twice = 2.0 * cross(-xyz, linear)
    v[:, :3] = linear + w * twice + cross(-xyz, twice)
    return v
