"""Give a smooth curve its time: Ruckig on the curve's parameter, under every joint's limits.

One scalar parameter is timed, so that the geometry cannot be left (several coordinates at once
would fall back silently, see the field notes), and never through Ruckig's waypoint interface, which
asks a server. Joint velocity, acceleration and jerk follow from the parameter's by the chain rule.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import ruckig
from numpy.typing import NDArray

from kinematics.curves import Curve
from kinematics.free_coordinates import FreeCoordinates
from kinematics.robot_model import RobotModel
from kinematics.trajectory import Stance, Trajectory

Array = NDArray[np.float64]

# Points of the curve at which its derivatives are bounded.
GRID = 201
# Share of acceleration that the curve's bending may use, and shares of the jerk.
BEND_SHARE = 0.4
TWIST_SHARE = 0.2
CROSS_SHARE = 0.3
# What is kept in reserve against what happens between the points of the grid.
ACCELERATION_RESERVE = 0.9
JERK_RESERVE = 0.8
# Distance of the samples; the motion between them is the cubic of their positions and velocities.
SAMPLE_S = 0.01
# Step of the central differences along the curve.
STEP = 1e-4


@dataclass(frozen=True, slots=True)
class Pace:
    """How fast a motion may be: shares of the velocity and acceleration limits."""

    velocity: float = 1.0
    acceleration: float = 1.0


def time_curve(
    model: RobotModel, space: FreeCoordinates, stance: Stance, curve: Curve, pace: Pace
) -> Trajectory | None:
    """Make the trajectory that runs a curve from rest to rest within all limits.

    Returns:
        The trajectory, or None when the legs cannot follow somewhere on the curve.
    """
    grid = np.linspace(0.0, 1.0, GRID)
    q, reached = space.to_q(curve(grid))
    if not reached.all():
        return None
    profile = _profile(model, q[:, 7:], pace)
    t = np.linspace(0.0, profile.duration, max(2, int(np.ceil(profile.duration / SAMPLE_S)) + 1))
    s, rate = np.array([_at(profile, time) for time in t]).T
    s = np.clip(s, 0.0, 1.0)
    q = space.to_q(curve(s))[0]
    before, after = np.maximum(s - STEP, 0.0), np.minimum(s + STEP, 1.0)
    q_before, q_after = space.to_q(curve(before))[0], space.to_q(curve(after))[0]
    v = _velocity(q, (q_after - q_before) / (after - before)[:, None]) * rate[:, None]
    v[0] = v[-1] = 0.0
    return Trajectory(joints=model.joints, stance=stance, t_s=t, q=q, v=v)


def _profile(model: RobotModel, joints: Array, pace: Pace) -> ruckig.Trajectory:
    step = 1.0 / (GRID - 1)
    d1 = np.abs(np.gradient(joints, step, axis=0)) + 1e-9
    d2 = np.abs(np.diff(joints, 2, axis=0)) / step**2
    d3 = np.abs(np.diff(joints, 3, axis=0)) / step**3
    d1_max, d2_max, d3_max = d1.max(axis=0), d2.max(axis=0) + 1e-9, d3.max(axis=0) + 1e-9
    velocity = model.velocity * pace.velocity
    acceleration = model.acceleration * pace.acceleration * ACCELERATION_RESERVE
    jerk = model.jerk * JERK_RESERVE
    v = float(
        min(
            np.min(velocity / d1_max),
            np.min(np.sqrt(BEND_SHARE * acceleration / d2_max)),
            np.min(np.cbrt(TWIST_SHARE * jerk / d3_max)),
        )
    )
    a = float(
        min(
            np.min((acceleration - d2_max * v * v) / d1_max),
            np.min(CROSS_SHARE * jerk / (3.0 * d2_max * v)),
        )
    )
    j = float(np.min((1.0 - TWIST_SHARE - CROSS_SHARE) * jerk / d1_max))
    order = ruckig.InputParameter(1)
    order.current_position, order.current_velocity, order.current_acceleration = [0.0], [0.0], [0.0]
    order.target_position = [1.0]
    order.max_velocity, order.max_acceleration, order.max_jerk = [v], [a], [j]
    trajectory = ruckig.Trajectory(1)
    ruckig.Ruckig(1).calculate(order, trajectory)
    return trajectory


def _at(profile: ruckig.Trajectory, time_s: float) -> tuple[float, float]:
    position, velocity, _ = profile.at_time(min(time_s, profile.duration))
    return position[0], velocity[0]


def _velocity(q: Array, slope: Array) -> Array:
    """Velocities in Pinocchio's convention from the derivative of ``q``, shapes (n, nq) to (n, nv)."""
    v = np.empty((len(q), q.shape[1] - 1))
    v[:, 6:] = slope[:, 7:]
    xyz, w = q[:, 3:6], q[:, 6:7]
    d_xyz, d_w = slope[:, 3:6], slope[:, 6:7]
    # local angular velocity 2 * conj(quaternion) * derivative
    v[:, 3:6] = 2.0 * (w * d_xyz - d_w * xyz - np.cross(xyz, d_xyz))
    # linear velocity turned into the base's frame: rotate by the conjugate
    linear = slope[:, :3]
    twice = 2.0 * np.cross(-xyz, linear)
    v[:, :3] = linear + w * twice + np.cross(-xyz, twice)
    return v
