"""Compiled: both legs in closed form, over feet that move."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.compiled.compiler import compiled


@compiled
def fill_legs(
    q: Array,
    base_R: Array,
    feet: Array,
    hip: Array,
    bones: Array,
    sole_R_ankle: Array,
    sole_p_ankle: Array,
    columns: NDArray[np.intp],
) -> bool:
    """Write the leg joints of one configuration; tell whether every foot is within reach.

    The closed form is that of ``kinematics.standing.leg_ik``, whose feet stand still.

    Args:
        q: Configuration, shape (nq,): its base position is read, ``columns`` are written.
        base_R: Orientation of the base, shape (3, 3).
        feet: x, y, height and heading of each sole, shape (legs, 4).
        hip: Where each hip's axes meet, in the base, shape (legs, 3).
        bones: Lengths of thigh and shin, shape (legs, 2).
        sole_R_ankle, sole_p_ankle: The ankle in the sole's frame, shapes (legs, 3, 3) and (legs, 3).
        columns: Where each leg's joints are in ``q``, hip to ankle, shape (legs, 6).
    """
    foot_R = np.empty((3, 3))
    for leg in range(feet.shape[0]):
        c, s = math.cos(feet[leg, 3]), math.sin(feet[leg, 3])
        R, p = sole_R_ankle[leg], sole_p_ankle[leg]
        for k in range(3):
            foot_R[0, k] = c * R[0, k] - s * R[1, k]
            foot_R[1, k] = s * R[0, k] + c * R[1, k]
            foot_R[2, k] = R[2, k]
        d = np.empty(3)
        ankle = (feet[leg, 0] + c * p[0] - s * p[1], feet[leg, 1] + s * p[0] + c * p[1], feet[leg, 2] + p[2])
        for k in range(3):
            d[k] = q[k] - ankle[k]
            for i in range(3):
                d[k] += base_R[k, i] * hip[leg, i]
        x = foot_R[0, 0] * d[0] + foot_R[1, 0] * d[1] + foot_R[2, 0] * d[2]
        y = foot_R[0, 1] * d[0] + foot_R[1, 1] * d[1] + foot_R[2, 1] * d[2]
        z = foot_R[0, 2] * d[0] + foot_R[1, 2] * d[1] + foot_R[2, 2] * d[2]
        a, b = bones[leg, 0], bones[leg, 1]
        distance = math.sqrt(x * x + y * y + z * z)
        if distance > a + b or distance < abs(a - b):
            return False
        knee = math.acos(min(1.0, max(-1.0, (distance * distance - a * a - b * b) / (2.0 * a * b))))
        inner = math.asin(min(1.0, max(-1.0, a / distance * math.sin(math.pi - knee))))
        roll = math.atan2(y, z)
        pitch = -math.atan2(x, math.sqrt(y * y + z * z)) - inner
        bend = -pitch - knee
        cr, sr, cb, sb = math.cos(roll), math.sin(roll), math.cos(bend), math.sin(bend)
        m01 = m11 = m20 = m21 = m22 = 0.0
        for k in range(3):
            along_y = cr * foot_R[k, 1] - sr * foot_R[k, 2]
            along_z = sr * foot_R[k, 1] + cr * foot_R[k, 2]
            f0 = cb * foot_R[k, 0] - sb * along_z
            f2 = sb * foot_R[k, 0] + cb * along_z
            m01 += base_R[k, 0] * along_y
            m11 += base_R[k, 1] * along_y
            m20 += base_R[k, 2] * f0
            m21 += base_R[k, 2] * along_y
            m22 += base_R[k, 2] * f2
        yaw = math.atan2(-m01, m11)
        q[columns[leg, 0]] = yaw
        q[columns[leg, 1]] = math.atan2(m21, -m01 * math.sin(yaw) + m11 * math.cos(yaw))
        q[columns[leg, 2]] = math.atan2(-m20, m22)
        q[columns[leg, 3]] = knee
        q[columns[leg, 4]] = pitch
        q[columns[leg, 5]] = roll
    return True
