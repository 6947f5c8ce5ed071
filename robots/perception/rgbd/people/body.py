"""How somebody is whose head was found: posture, and what the arms do."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, InFloat64
from robots.perception.rgbd.people.heads import HEAD_M, Head
from robots.perception.rgbd.people.pieces import Piece
from robots.scenes.scene_description import Posture

_STANDS_M, _SITS_M = 1.36, 0.85
"""Heights of the middle of a grown person's head who stands, or sits, and not lower."""
_LIES_M = 0.60
"""Nobody who lies is higher than this."""
_LONG_M = (1.1, 2.2)
_HEAD_BEYOND_M, _BESIDE_LINE_M = 0.40, 0.36
_NARROWER = 0.80
"""A head is narrower than this times the width of shoulders or of one half of them."""
_SHIN_M, _SEATED_M = 0.35, 1.0
_LAP_M = 0.22
"""The knees of who sits are so far from the trunk."""
SHOULDER_M = 0.22
"""From the middle of the head down to the shoulders."""
_ARM_M = 0.85
_CLEAR_M = 0.17
"""Farther from the middle of the head than this is no head."""
_BESIDE_M = 0.33
"""An arm that goes out to the side is farther from the trunk's axis, and so is the hand of who waves."""
_UP_M, _LEVEL_M = 0.07, 0.16
_LEAST_ARM_M2 = 0.0035
_TRUNK_M = 0.13


@dataclass(frozen=True, slots=True)
class Body(InFloat64):
    """Somebody.

    Attributes:
        head: The head.
        axis: Where the trunk's axis meets the floor, shape (2,); of who lies the middle of the body.
        posture: None where it cannot be told.
        points, pixels: What belongs to the body: places, shape (n, 3), and rows and columns in the whole
            picture, shape (n, 2).
        along: Of who lies, from the feet to the head, of unit length, shape (2,); None else.
        area_m2: Of each point.
    """

    head: Head
    axis: Array
    posture: Posture | None
    points: Array
    pixels: NDArray[np.int64]
    along: Array | None
    area_m2: float


def posture_of(head: Head, points: Array, axis: Array) -> Posture | None:
    """How somebody is whose head is above the trunk, or None where it cannot be told.

    Args:
        head: The head.
        points: Of the whole body, shape (n, 3).
        axis: Where the trunk's axis meets the floor.
    """
    height = float(head.middle[2])
    if height > _STANDS_M:
        return "standing"
    if height < _SITS_M:
        return None
    away = np.linalg.norm(points[:, :2] - axis, axis=1)
    low = points[:, 2] < height - 0.62
    if low.sum() >= 10 and float(np.quantile(away[low], 0.9)) > _LAP_M:
        return "sitting"
    # legs that go straight down to the floor are those of a child who stands
    straight = (points[:, 2] < _SHIN_M) & (away < _LAP_M)
    return None if straight.sum() >= 20 or height < _SEATED_M else "sitting"


def trunk_axis(head: Head, points: Array, eye: Array) -> Array:
    """Where the axis of an upright trunk meets the floor: half a trunk behind what is seen of it."""
    below = head.middle[2] - points[:, 2]
    near = np.linalg.norm(points[:, :2] - head.middle[:2], axis=1) < 0.24
    trunk = points[(below > 0.26) & (below < 0.60) & near]
    if len(trunk) < 20:
        return np.asarray(head.middle[:2].copy())
    ahead = head.middle[:2] - eye[:2]
    ahead /= np.linalg.norm(ahead)
    across = np.array([-ahead[1], ahead[0]])
    sideways = (trunk[:, :2] - head.middle[:2]) @ across
    # arms hang beside the trunk and hide no more than its rims
    middle = trunk[np.abs(sideways) < 0.08]
    if len(middle) < 10:
        return np.asarray(head.middle[:2].copy())
    depth = float(np.median((middle[:, :2] - head.middle[:2]) @ ahead)) + 0.9 * _TRUNK_M
    # head and trunk are in one line, mostly
    return np.asarray(head.middle[:2] + 0.5 * np.clip(depth, -0.15, 0.15) * ahead)


def limbs_near(head: Head, axis: Array, own: Piece, others: Sequence[Piece]) -> list[Piece]:
    """Other pieces that may be arms or legs: small ones that are all within an arm's length."""
    found = []
    for piece in others:
        if piece is own or piece.area_m2 > 0.25:
            continue
        away = np.linalg.norm(piece.points[:, :2] - axis, axis=1)
        top = head.middle[2] + 0.60
        if float(np.quantile(away, 0.98)) < _ARM_M and piece.top_m < top and float(away.min()) < 0.6:
            found.append(piece)
    return found


def gesture_of(body: Body, yaw_rad: float | None) -> str | None:
    """What the arms do, with the side where that can be told; None for nothing.

    Args:
        body: Who sits or stands.
        yaw_rad: Where the person faces; None where that cannot be told.
    """
    shoulder = float(body.head.middle[2]) - SHOULDER_M
    points = body.points
    from_axis = points[:, :2] - body.axis
    away = np.linalg.norm(from_axis, axis=1)
    off_head = np.linalg.norm(points - body.head.middle, axis=1) > _CLEAR_M
    off_head &= (np.linalg.norm(points[:, :2] - body.head.middle[:2], axis=1) > 0.135) | (
        points[:, 2] > body.head.middle[2] + 0.17
    )
    up = off_head & (points[:, 2] > shoulder + _UP_M) & (away < _ARM_M)
    out = (away > _BESIDE_M) & (away < _ARM_M) & (np.abs(points[:, 2] - shoulder) < _LEVEL_M)
    raised = float(up.sum()) * body.area_m2
    level = float(out.sum()) * body.area_m2
    if raised < _LEAST_ARM_M2 and level < _LEAST_ARM_M2:
        return None
    if raised >= _LEAST_ARM_M2:
        reach = float(np.quantile(away[up], 0.6))
        which = up if reach < _BESIDE_M else up | out
        verb = "waving" if reach > _BESIDE_M else "raising"
    else:
        if float(np.quantile(away[out], 0.9)) < 0.45:
            return None
        which, verb = out, "pointing"
    if verb == "waving":
        return verb
    if yaw_rad is None:
        return None
    side = np.array([-np.sin(yaw_rad), np.cos(yaw_rad)])
    left = float(np.median(from_axis[which] @ side)) > 0.0
    word = "left" if left else "right"
    return f"raising {word} arm" if verb == "raising" else f"pointing {word}"


def in_line(piece: Piece, others: Sequence[Piece]) -> list[Piece]:
    """Other low pieces that lie along the same line: a head behind its trunk, an arm beside it."""
    flat = piece.points[:, :2]
    middle = flat.mean(axis=0)
    _, _, axes = np.linalg.svd(flat - middle, full_matrices=False)
    reach = float(np.abs((flat - middle) @ axes[0]).max()) + _HEAD_BEYOND_M
    found = []
    for other in others:
        if other is piece or other.top_m > _LIES_M or other.area_m2 > piece.area_m2:
            continue
        off = other.points[:, :2] - middle
        if np.abs(off @ axes[1]).max() < _BESIDE_LINE_M and np.abs(off @ axes[0]).max() < reach:
            found.append(other)
    return found


def lying_body(points: Array) -> tuple[Array, Array, float] | None:
    """Of what may be somebody who lies: the middle, the direction from the feet to the head, the length.

    A head is narrower than what follows it, feet are not. None where neither end is so.
    """
    flat = points[:, :2]
    middle = flat.mean(axis=0)
    _, _, axes = np.linalg.svd(flat - middle, full_matrices=False)
    along = np.asarray(axes[0])
    place, aside = (flat - middle) @ along, (flat - middle) @ axes[1]
    low, high = (float(value) for value in np.quantile(place, (0.003, 0.997)))
    if not _LONG_M[0] < high - low < _LONG_M[1]:
        return None
    ends = []
    for end, sign in ((high, 1.0), (low, -1.0)):
        within = sign * (end - place)
        tip, follows = _wide_m(aside[within < 0.16]), _wide_m(aside[(within > 0.30) & (within < 0.62)])
        ends.append(tip / max(follows, 0.05))
    if min(ends) > _NARROWER:
        return None
    return middle + 0.5 * (low + high) * along, along if ends[0] < ends[1] else -along, high - low


def _wide_m(aside: Array) -> float:
    if len(aside) < 8:
        return 0.0
    low, high = np.quantile(aside, (0.03, 0.97))
    return float(high - low)


def may_lie(piece: Piece) -> bool:
    """Whether a piece is as low and as long as somebody who lies."""
    if piece.area_m2 < 0.08 or piece.top_m > _LIES_M:
        return False
    flat = piece.points[:, :2]
    spread = np.linalg.svd(flat - flat.mean(axis=0), compute_uv=False) / len(flat) ** 0.5
    return bool(spread[0] > 0.28 and spread[1] < 0.28)


def may_stand(piece: Piece) -> bool:
    """Whether a piece is as high as somebody who sits or stands, and no wall."""
    if piece.area_m2 < 0.03 or piece.top_m <= _SITS_M + HEAD_M:
        return False
    flat = piece.points[:, :2]
    reach = np.linalg.norm(flat - np.median(flat, axis=0), axis=1)
    return bool(np.quantile(reach, 0.9) < 1.1)
