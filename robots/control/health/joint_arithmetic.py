"""Compiled arithmetic of the judgement of joints: arrays of thirty are too small for array calls."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.compiled.compiler import compiled

Flags = NDArray[np.bool_]


@compiled
def add_travel(travel: Array, v_before: Array, v: Array, half_s: float) -> None:
    """Add the way of twice ``half_s`` to ``travel``, and keep its speed in ``v_before``; shape (n,) each."""
    for j in range(travel.shape[0]):
        travel[j] += half_s * (v_before[j] + v[j])
        v_before[j] = v[j]


@compiled
def watch_motors(
    q: Array,
    v: Array,
    effort: Array,
    told_q: Array,
    told_v: Array,
    told_tau: Array,
    servo: Array,
    share: float,
    least_fraction: float,
    missing_share: float,
    room: float,
    mean: Array,
    missing: Array,
    bound: Array,
) -> bool:
    """Average what the servos ask for and what the motors give, and compare.

    Args:
        q, v, effort: Readings, shape (n,).
        told_q, told_v, told_tau: The setpoint, at least n each.
        servo: Stiffness, damping and effort limit, shape (3, n).
        share: Of the newest reading in the averages.
        least_fraction: Of the effort limit: less is never missing.
        missing_share: Of what is asked for: less is never missing.
        room: The bound is multiplied by this.
        mean: The averages of what is asked for and of what is given, shape (2, n); brought up to date.
        missing, bound: Results, Nm, shape (n,).

    Returns:
        Whether any motor misses more than its bound.
    """
    any_missing = False
    for j in range(q.shape[0]):
        asked = servo[0, j] * (told_q[j] - q[j]) + servo[1, j] * (told_v[j] - v[j]) + told_tau[j]
        asked = min(max(asked, -servo[2, j]), servo[2, j])
        mean[0, j] += share * (asked - mean[0, j])
        mean[1, j] += share * (effort[j] - mean[1, j])
        missing[j] = abs(mean[0, j] - mean[1, j])
        bound[j] = room * max(least_fraction * servo[2, j], missing_share * abs(mean[0, j]))
        any_missing |= missing[j] > bound[j]
    return any_missing


@compiled
def watch_followers(
    wanted: Array,
    q: Array,
    then_wanted: Array,
    then_q: Array,
    stuck_rad: Array,
    tracking_rad: float,
    followed_share: float,
    room: float,
    passed_s: float,
    longest_s: float,
    off_rad: Array,
    behind_s: Array,
    stuck: Flags,
) -> bool:
    """Tell which joints do not follow their setpoints.

    Args:
        wanted, q: Setpoint, at least n, and reading, shape (n,), rad.
        then_wanted, then_q: The same some time ago.
        stuck_rad: From how far a joint may be called stuck, shape (n,).
        tracking_rad: From how far it is, whatever it does.
        followed_share: A joint that moves by less than this share of its setpoint's way does not follow.
        room: All distances are multiplied by this.
        passed_s: Time since the last judgement.
        longest_s: A joint that stays behind for longer is stuck.
        off_rad: Result: distance from the setpoint, shape (n,).
        behind_s: For how long each joint has been behind, shape (n,); brought up to date.
        stuck: Result, shape (n,).

    Returns:
        Whether any joint is stuck.
    """
    any_stuck = False
    for j in range(q.shape[0]):
        moved, followed = abs(wanted[j] - then_wanted[j]), abs(q[j] - then_q[j])
        off = abs(wanted[j] - q[j])
        off_rad[j] = off
        behind_s[j] = behind_s[j] + passed_s if off > room * stuck_rad[j] else 0.0
        still = moved > stuck_rad[j] and followed < followed_share * moved and off > 0.5 * room * stuck_rad[j]
        stuck[j] = still or off > room * tracking_rad or behind_s[j] > longest_s
        any_stuck |= stuck[j]
    return any_stuck


@compiled
def watch_encoders(
    q: Array, travel: Array, forgotten: float, bound_rad: float, origin: Array, slipped: Array
) -> bool:
    """Tell by how much positions and the sum of speeds disagree.

    Args:
        q: Readings, rad, shape (n,).
        travel: Sum of the speeds since ``origin``, rad, shape (n,).
        forgotten: Share of the disagreement that is forgotten now.
        bound_rad: Up to which it is noise.
        origin: Where the sum began, shape (n,); brought up to date.
        slipped: Result, rad, shape (n,).

    Returns:
        Whether any of them is beyond the bound.
    """
    any_slipped = False
    for j in range(q.shape[0]):
        slipped[j] = q[j] - origin[j] - travel[j]
        origin[j] += forgotten * slipped[j]
        any_slipped |= abs(slipped[j]) > bound_rad
    return any_slipped
