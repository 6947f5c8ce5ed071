"""Compiled: what is computed each control period from orientation, soles and CoM."""

from __future__ import annotations

import math

import numpy as np

from kinematics.arrays import Array
from kinematics.compiled.compiler import compiled, inlined

_LEVEL, _ON_AN_EDGE = 0.012, 0.025
"""Sine of a sole's lean: below the first it is taken for level, above the second it says nothing about the
trunk. A gyro's error of 0.5 degrees per second, corrected by level soles, stays below the first."""


@inlined
def _rotation(x: float, y: float, z: float) -> Array:
    """Rotation of a rotation vector, by Rodrigues' formula."""
    angle2 = x * x + y * y + z * z
    angle = math.sqrt(angle2)
    if angle < 1e-6:
        a, b = 1.0 - angle2 / 6.0, 0.5 - angle2 / 24.0
    else:
        a, b = math.sin(angle) / angle, (1.0 - math.cos(angle)) / angle2
    R = np.empty((3, 3))
    R[0, 0], R[1, 1], R[2, 2] = (
        1.0 - b * (y * y + z * z),
        1.0 - b * (x * x + z * z),
        1.0 - b * (x * x + y * y),
    )
    R[0, 1], R[1, 0] = b * x * y - a * z, b * x * y + a * z
    R[0, 2], R[2, 0] = b * x * z + a * y, b * x * z - a * y
    R[1, 2], R[2, 1] = b * y * z - a * x, b * y * z + a * x
    return R


@inlined
def _product(A: Array, B: Array) -> Array:
    C = np.empty((3, 3))
    for i in range(3):
        for j in range(3):
            C[i, j] = A[i, 0] * B[0, j] + A[i, 1] * B[1, j] + A[i, 2] * B[2, j]
    return C


@inlined
def _wrapped(angle: float) -> float:
    return (angle + math.pi) % (2.0 * math.pi) - math.pi


@compiled
def turned(
    odom_R_base: Array,
    rate: Array,
    dt: float,
    loads: Array,
    sole_R: Array,
    relied: int,
    anchor_yaw: float,
    force: Array,
    times_s: Array,
    sole_rate: float,
) -> Array:
    """Integrate the gyro, then bring the soles that carry, and gravity, a little nearer to upright.

    Args:
        odom_R_base: Orientation before, shape (3, 3).
        rate: Angular velocity in the base's frame, rad/s, shape (3,).
        dt: Time since then, s.
        loads: Normal force on each sole, 0 where it carries nothing, shape (feet,).
        sole_R: Each sole in the base's frame, shape (feet, 3, 3).
        relied: Index of the sole whose heading is known.
        anchor_yaw: That heading.
        force: What the accelerometer shows, in the base's frame, m/s^2, shape (3,).
        times_s: Time constants: soles, heading, gravity, shape (3,).
        sole_rate: Soles turn the tilt no faster than this, rad/s; those that lean much do not at all.

    Returns:
        Orientation now, shape (3, 3).
    """
    R = _product(odom_R_base, _rotation(rate[0] * dt, rate[1] * dt, rate[2] * dt))
    ex = ey = ez = 0.0
    total = 0.0
    for k in range(len(loads)):
        total += loads[k]
    if total > 0.0:
        gain = dt / times_s[0]
        for k in range(len(loads)):
            if loads[k] <= 0.0:
                continue
            sole = _product(R, sole_R[k])
            lean = math.sqrt(sole[0, 2] ** 2 + sole[1, 2] ** 2)
            believed = min(1.0, max(0.0, (_ON_AN_EDGE - lean) / (_ON_AN_EDGE - _LEVEL)))
            share = believed * gain * loads[k] / total
            # the turn that brings the sole's z axis up
            ex += share * sole[1, 2]
            ey -= share * sole[0, 2]
            if k == relied:
                ez += dt / times_s[1] * _wrapped(anchor_yaw - math.atan2(sole[1, 0], sole[0, 0]))
        turn, most = math.sqrt(ex * ex + ey * ey), sole_rate * dt
        if turn > most:
            ex, ey = ex * most / turn, ey * most / turn
    fx = R[0, 0] * force[0] + R[0, 1] * force[1] + R[0, 2] * force[2]
    fy = R[1, 0] * force[0] + R[1, 1] * force[1] + R[1, 2] * force[2]
    fz = R[2, 0] * force[0] + R[2, 1] * force[1] + R[2, 2] * force[2]
    gain = dt / times_s[2]
    size = max(math.sqrt(fx * fx + fy * fy + fz * fz), 1e-6)
    ex += gain * fy / size
    ey -= gain * fx / size
    return _product(_rotation(ex, ey, ez), R)


@compiled
def base_velocity(
    before: Array,
    odom_R_base: Array,
    force: Array,
    dt: float,
    loads: Array,
    sole_p: Array,
    sole_v: Array,
    rate: Array,
    time_s: float,
    most: float,
) -> Array:
    """Integrate the accelerometer, then go to what the soles that carry say, were they at rest.

    A sole that rocks on an edge is not at rest: it shows velocities of some 0.3 m/s to and fro for 30 ms.
    So what it says counts with a time constant, and differences count up to a bound.

    Args:
        before: Velocity of the base in odometry axes, m/s, shape (3,).
        odom_R_base: Orientation, shape (3, 3).
        force: What the accelerometer shows, in the base's frame, m/s^2, shape (3,).
        dt: Time since then, s.
        loads: Normal force on each sole, 0 where it carries nothing, shape (feet,).
        sole_p, sole_v: Each sole in the base's frame and its velocity there, shape (feet, 3) each.
        rate: Angular velocity of the base in its own frame, rad/s, shape (3,).
        time_s: Time constant of the soles.
        most: Of a difference, m/s.

    Returns:
        Velocity now, shape (3,).
    """
    total = 0.0
    for k in range(len(loads)):
        total += loads[k]
    R = odom_R_base
    v = before.copy()
    for i in range(3):
        v[i] += dt * (R[i, 0] * force[0] + R[i, 1] * force[1] + R[i, 2] * force[2])
    v[2] -= dt * 9.81
    if total > 0.0:
        off = np.zeros(3)
        for k in range(len(loads)):
            p, share = sole_p[k], loads[k] / total
            x = sole_v[k, 0] + rate[1] * p[2] - rate[2] * p[1]
            y = sole_v[k, 1] + rate[2] * p[0] - rate[0] * p[2]
            z = sole_v[k, 2] + rate[0] * p[1] - rate[1] * p[0]
            for i in range(3):
                off[i] -= share * (R[i, 0] * x + R[i, 1] * y + R[i, 2] * z)
        size = 0.0
        for i in range(3):
            off[i] -= v[i]
            size += off[i] * off[i]
        size = math.sqrt(size)
        gain = dt / time_s * min(1.0, most / max(size, 1e-9))
        for i in range(3):
            v[i] += gain * off[i]
    return v


@compiled
def com_seen(
    odom_R_base: Array,
    sole_R: Array,
    sole_p: Array,
    base_v: Array,
    com: Array,
    com_v: Array,
    rate: Array,
) -> Array:
    """The CoM as a sole sees it, along the sole's heading.

    Args:
        odom_R_base: Orientation, shape (3, 3).
        sole_R, sole_p: The sole in the base's frame, shapes (3, 3) and (3,).
        base_v: Velocity of the base over the floor, odometry axes, m/s, shape (3,).
        com, com_v: The CoM and its velocity in the base's frame, shape (3,) each.
        rate: Angular velocity of the base in its own frame, rad/s, shape (3,).

    Returns:
        Position (3), velocity (3), and the base's heading from the sole, shape (7,).
    """
    c0 = (
        odom_R_base[0, 0] * sole_R[0, 0] + odom_R_base[0, 1] * sole_R[1, 0] + odom_R_base[0, 2] * sole_R[2, 0]
    )
    s0 = (
        odom_R_base[1, 0] * sole_R[0, 0] + odom_R_base[1, 1] * sole_R[1, 0] + odom_R_base[1, 2] * sole_R[2, 0]
    )
    heading = math.atan2(s0, c0)
    c, s = math.cos(heading), math.sin(heading)
    arm = com - sole_p
    moving = np.empty(3)
    moving[0] = com_v[0] + rate[1] * com[2] - rate[2] * com[1]
    moving[1] = com_v[1] + rate[2] * com[0] - rate[0] * com[2]
    moving[2] = com_v[2] + rate[0] * com[1] - rate[1] * com[0]
    seen = np.empty(7)
    R = odom_R_base
    for k in range(2):
        v = arm if k == 0 else moving
        x = R[0, 0] * v[0] + R[0, 1] * v[1] + R[0, 2] * v[2]
        y = R[1, 0] * v[0] + R[1, 1] * v[1] + R[1, 2] * v[2]
        z = R[2, 0] * v[0] + R[2, 1] * v[1] + R[2, 2] * v[2]
        if k == 1:
            x, y, z = x + base_v[0], y + base_v[1], z + base_v[2]
        seen[3 * k], seen[3 * k + 1], seen[3 * k + 2] = c * x + s * y, c * y - s * x, z
    seen[6] = _wrapped(math.atan2(R[1, 0], R[0, 0]) - heading)
    return seen


@compiled
def righting_moment(
    odom_R_base: Array,
    heading: float,
    quaternion: Array,
    rate: Array,
    plan_turn: float,
    stiffness: float,
    damping: float,
) -> Array:
    """Moment that turns the trunk to where a plan has it, in the plan's axes, shape (3,).

    Args:
        odom_R_base: Measured orientation, shape (3, 3).
        heading: The measured heading in the plan's frame.
        quaternion: The planned orientation (x, y, z, w), shape (4,).
        rate: Measured angular velocity in the base's frame, rad/s, shape (3,).
        plan_turn: The planned turning about the vertical, rad/s.
        stiffness, damping: Nm/rad and Nms/rad.
    """
    angle = heading - math.atan2(odom_R_base[1, 0], odom_R_base[0, 0])
    c, s = math.cos(angle), math.sin(angle)
    R = np.empty((3, 3))
    for j in range(3):
        R[0, j] = c * odom_R_base[0, j] - s * odom_R_base[1, j]
        R[1, j] = s * odom_R_base[0, j] + c * odom_R_base[1, j]
        R[2, j] = odom_R_base[2, j]
    x, y, z, w = quaternion[0], quaternion[1], quaternion[2], quaternion[3]
    norm = math.sqrt(x * x + y * y + z * z + w * w)
    x, y, z, w = x / norm, y / norm, z / norm, w / norm
    P = np.empty((3, 3))
    P[0, 0], P[0, 1], P[0, 2] = 1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)
    P[1, 0], P[1, 1], P[1, 2] = 2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)
    P[2, 0], P[2, 1], P[2, 2] = 2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)
    off = np.empty((3, 3))
    for i in range(3):
        for j in range(3):
            off[i, j] = R[i, 0] * P[j, 0] + R[i, 1] * P[j, 1] + R[i, 2] * P[j, 2]
    moment = np.empty(3)
    moment[0], moment[1], moment[2] = off[2, 1] - off[1, 2], off[0, 2] - off[2, 0], off[1, 0] - off[0, 1]
    for i in range(3):
        turning = R[i, 0] * rate[0] + R[i, 1] * rate[1] + R[i, 2] * rate[2]
        if i == 2:
            turning -= plan_turn
        moment[i] = -(0.5 * stiffness * moment[i] + damping * turning)
    return moment
