"""Compiled: from free coordinates to a configuration, and how far its numbers can move on an edge."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.compiled.compiler import compiled, inlined
from kinematics.model.forward_kinematics import quaternion_to_rotation
from kinematics.model.tree import Tree
from kinematics.standing.flat_coordinates import Coordinates, Limits


@compiled
def configurations(space: Coordinates, tree: Tree, x: Array, q: Array, reached: NDArray[np.bool_]) -> None:
    """Write configurations.

    Args:
        space, tree: The robot on its feet.
        x: Points, shape (n, size).
        q: Result, shape (n, nq).
        reached: Result: whether every foot can be kept, shape (n,).
    """
    base_R = np.empty((3, 3))
    for k in range(x.shape[0]):
        reached[k] = configuration(space, tree, x[k], q[k], base_R)


@compiled
def configuration(space: Coordinates, tree: Tree, x: Array, q: Array, base_R: Array) -> bool:
    """Write ``q`` of free coordinates; tell whether every planted foot can be reached.

    The legs' closed form is that of ``kinematics.standing.leg_ik``. ``base_R``, shape (3, 3), is scratch.
    """
    first = 0
    if space.floating == 1:
        first = 6
        for k in range(3):
            q[k] = x[k]
        angle = math.sqrt(x[3] * x[3] + x[4] * x[4] + x[5] * x[5])
        # sin(a/2)/a, with its series near zero
        half = 0.5 - angle * angle / 48.0 if angle < 1e-6 else math.sin(0.5 * angle) / angle
        for k in range(3):
            q[3 + k] = half * x[3 + k]
        q[6] = math.cos(0.5 * angle)
    for k in range(space.columns.shape[0]):
        q[space.columns[k]] = x[first + k]
    if space.leg_bodies.shape[0] == 0:
        return True
    quaternion_to_rotation(q[3], q[4], q[5], q[6], base_R)
    reached = True
    for leg in range(space.leg_bodies.shape[0]):
        if not _leg(space, tree, leg, base_R, q):
            reached = False
    return reached


@inlined
def _hip_from_ankle(space: Coordinates, leg: int, base_R: Array, q: Array) -> tuple[float, float, float]:
    """The hip as the planted ankle's frame sees it, m."""
    hip, foot, ankle = space.hip[leg], space.foot_R[leg], space.ankle[leg]
    d0 = q[0] + base_R[0, 0] * hip[0] + base_R[0, 1] * hip[1] + base_R[0, 2] * hip[2] - ankle[0]
    d1 = q[1] + base_R[1, 0] * hip[0] + base_R[1, 1] * hip[1] + base_R[1, 2] * hip[2] - ankle[1]
    d2 = q[2] + base_R[2, 0] * hip[0] + base_R[2, 1] * hip[1] + base_R[2, 2] * hip[2] - ankle[2]
    return (
        foot[0, 0] * d0 + foot[1, 0] * d1 + foot[2, 0] * d2,
        foot[0, 1] * d0 + foot[1, 1] * d1 + foot[2, 1] * d2,
        foot[0, 2] * d0 + foot[1, 2] * d1 + foot[2, 2] * d2,
    )


@inlined
def _knee(a: float, b: float, distance: float) -> float:
    cosine = (distance * distance - a * a - b * b) / (2.0 * a * b)
    return math.acos(min(1.0, max(-1.0, cosine)))


@inlined
def _inner(a: float, distance: float, knee: float) -> float:
    """Angle between the shin and the line from ankle to hip."""
    return math.asin(min(1.0, max(-1.0, a / max(distance, 1e-9) * math.sin(math.pi - knee))))


@compiled
def _leg(space: Coordinates, tree: Tree, leg: int, base_R: Array, q: Array) -> bool:
    x, y, z = _hip_from_ankle(space, leg, base_R, q)
    a, b = space.bones[leg, 0], space.bones[leg, 1]
    distance = math.sqrt(x * x + y * y + z * z)
    if distance > a + b or distance < abs(a - b):
        return False
    knee = _knee(a, b, distance)
    roll = math.atan2(y, z)
    pitch = -math.atan2(x, math.sqrt(y * y + z * z)) - _inner(a, distance, knee)
    # M = base_R^T foot_R Rx(-roll) Ry(bend) is the thigh in the base: hip yaw, roll, pitch
    bend = -pitch - knee
    cr, sr, cb, sb = math.cos(roll), math.sin(roll), math.cos(bend), math.sin(bend)
    F = space.foot_R[leg]
    m01 = 0.0
    m11 = 0.0
    m20 = 0.0
    m21 = 0.0
    m22 = 0.0
    for k in range(3):
        # row k of foot_R Rx(-roll) Ry(bend)
        along_y = cr * F[k, 1] - sr * F[k, 2]
        along_z = sr * F[k, 1] + cr * F[k, 2]
        f0 = cb * F[k, 0] - sb * along_z
        f2 = sb * F[k, 0] + cb * along_z
        m01 += base_R[k, 0] * along_y
        m11 += base_R[k, 1] * along_y
        m20 += base_R[k, 2] * f0
        m21 += base_R[k, 2] * along_y
        m22 += base_R[k, 2] * f2
    yaw = math.atan2(-m01, m11)
    bodies = space.leg_bodies[leg]
    q[tree.column[bodies[0]]] = yaw
    q[tree.column[bodies[1]]] = math.atan2(m21, -m01 * math.sin(yaw) + m11 * math.cos(yaw))
    q[tree.column[bodies[2]]] = math.atan2(-m20, m22)
    q[tree.column[bodies[3]]] = knee
    q[tree.column[bodies[4]]] = pitch
    q[tree.column[bodies[5]]] = roll
    return True


@compiled
def leg_ranges(
    space: Coordinates, tree: Tree, q: Array, base_R: Array, step: float, turn: float, reach: Array
) -> bool:
    """How far each leg joint can turn while the base moves a little.

    Every bound is a fact of triangles and spheres, none an estimate: the knee and the shin's lean
    are monotone in the distance of hip and ankle, which changes by no more than the hip moves; an
    azimuth changes by no more than asin(sin(turn) / sin(distance from the pole)).

    Args:
        space, tree: The robot.
        q: Configuration in the middle, legs filled.
        base_R: Its base's rotation, shape (3, 3).
        step, turn: The base moves and turns by no more than this, m and rad.
        reach: Result by body, rad; only the legs' entries are written.

    Returns:
        False when a leg can get so near to stretched that nothing is bounded; ``reach`` is then pi.
    """
    bounded = True
    for leg in range(space.leg_bodies.shape[0]):
        bodies = space.leg_bodies[leg]
        if step == 0.0 and turn == 0.0:
            for k in range(6):
                reach[bodies[k]] = 0.0
            continue
        hip = space.hip[leg]
        moved = step + turn * math.sqrt(hip[0] * hip[0] + hip[1] * hip[1] + hip[2] * hip[2])
        x, y, z = _hip_from_ankle(space, leg, base_R, q)
        a, b = space.bones[leg, 0], space.bones[leg, 1]
        distance = math.sqrt(x * x + y * y + z * z)
        across = math.sqrt(y * y + z * z)
        near, far = distance - moved, distance + moved
        hip_roll = q[tree.column[bodies[1]]]
        hip_pole = math.cos(hip_roll)
        knee = q[tree.column[bodies[3]]]
        if far >= a + b or near <= math.sqrt(abs(b * b - a * a)) or near <= abs(a - b) or moved >= across:
            bounded = False
        else:
            knee_near, knee_far = _knee(a, b, near), _knee(a, b, far)
            lean = _inner(a, distance, knee)
            d_inner = max(abs(_inner(a, near, knee_near) - lean), abs(_inner(a, far, knee_far) - lean))
            d_knee = max(knee_near - knee, knee - knee_far)
            d_roll = math.asin(moved / across)
            d_pitch = math.asin(moved / distance) + d_inner
            side = turn + d_roll
            whole = side + d_pitch + d_knee
            if whole < 1.5 and math.sin(whole) < hip_pole:
                reach[bodies[0]] = math.asin(math.sin(side) / hip_pole)
                reach[bodies[1]] = side
                reach[bodies[2]] = math.asin(math.sin(whole) / hip_pole)
                reach[bodies[3]] = d_knee
                reach[bodies[4]] = d_pitch
                reach[bodies[5]] = d_roll
                continue
            bounded = False
        for k in range(6):
            reach[bodies[k]] = math.pi
    return bounded


@inlined
def limits_kept(limits: Limits, q: Array) -> bool:
    """Tell whether every joint is inside its limits."""
    kept = True
    for k in range(limits.lower.shape[0]):
        if q[k] < limits.lower[k] or q[k] > limits.upper[k]:
            kept = False
    return kept


@inlined
def com_room(limits: Limits, com: Array) -> float:
    """Distance of the CoM's ground projection to where its margin ends, m; infinite without a polygon."""
    room = math.inf
    for k in range(limits.offset.shape[0]):
        room = min(room, limits.inward[k, 0] * com[0] + limits.inward[k, 1] * com[1] - limits.offset[k])
    return room
