"""Compiled arithmetic of what holds joints back: arrays of thirty are too small for array calls."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.compiled.compiler import compiled

Indices = NDArray[np.intp]


@compiled
def average_resistance(
    q: Array,
    v: Array,
    effort: Array,
    needed: Array,
    viscous: float,
    share: float,
    outside: Array,
    mean_q: Array,
) -> None:
    """Bring two averages up to date, which lag behind alike.

    Args:
        q, v, effort: Readings, shape (n,).
        needed: Effort that the motion needs without friction, at least n, Nm.
        viscous: Effort that each rad/s loses, Nms/rad.
        share: Of the newest reading in the averages.
        outside: Average effort beyond what is needed, shape (n,), Nm.
        mean_q: Average position, shape (n,), rad.
    """
    for j in range(q.shape[0]):
        outside[j] += share * (effort[j] - needed[j] - viscous * v[j] - outside[j])
        mean_q[j] += share * (q[j] - mean_q[j])


@compiled
def find_jammed(
    joints: Indices,
    bound: Array,
    outside: Array,
    mean_q: Array,
    off: Array,
    frozen_rad: float,
    felt_share: float,
    room: float,
    anchor: Array,
    least: Array,
    most: Array,
) -> int:
    """The joint of one arm whose motor pushes against something that no other joint of it feels, or -1.

    Args:
        joints: Of the arm, shape (k,).
        bound: Pushing less than this is none, shape (k,), Nm.
        outside: Average effort beyond what motions need, shape (n,), Nm.
        mean_q: Average position, shape (n,), rad.
        off: How far the setpoint is ahead of the joint, at least n, rad.
        frozen_rad: A joint that moved by less has not moved.
        felt_share: What presses from outside is felt by another joint of the arm by at least this share.
        room: All bounds are multiplied by this.
        anchor: Where each joint has not moved from, shape (k,), rad; brought up to date.
        least, most: Efforts beyond what is needed since then, shape (k,), Nm; brought up to date.
    """
    jammed = -1
    for i in range(joints.shape[0]):
        j = joints[i]
        if abs(mean_q[j] - anchor[i]) > frozen_rad:
            anchor[i], least[i], most[i] = mean_q[j], outside[j], outside[j]
        least[i], most[i] = min(least[i], outside[j]), max(most[i], outside[j])
        pushed = abs(outside[j])
        if pushed <= room * bound[i] or outside[j] * off[j] <= 0.0:
            continue
        if most[i] - least[i] < 0.5 * room * bound[i]:
            continue  # what it pushes against gave way before
        felt = 0.0
        for other in range(joints.shape[0]):
            if other != i:
                felt = max(felt, abs(outside[joints[other]]))
        if felt <= felt_share * pushed:
            jammed = j
    return jammed
