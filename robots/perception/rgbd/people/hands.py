"""What people hold out: things in the air, ahead of somebody's trunk, on a hand."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, InFloat64
from kinematics.geometry.shapes import Box
from robots.perception.rgbd.cloud import Cloud
from robots.perception.rgbd.labels import Call
from robots.perception.rgbd.people.find import SeenPerson
from robots.perception.rgbd.picture import Mask
from robots.perception.rgbd.segments import TINT_CHANGE, Segments, segment

_REACH_M = 1.2
"""Nobody holds anything farther from the axis of the trunk."""
_LOWEST_M, _HIGHEST_M = 0.5, 1.7
_HELD_OUT_M = 0.27
"""What is nearer to the axis than this is trunk, or an arm that hangs, unless its colour is another."""
_JOINED_PIXELS, _JOINED_M = 8, 0.03
_GOES_ON_M, _GOES_ON_SHARE = 0.015, 0.4
"""What is a part of the clothes goes on in them along its edge; what is held before them stands out."""
_HEAD_M = 0.30
_BAND_M = 0.25
"""Of a shirt and trousers each is at least so high."""
_FAR_M = 100.0
_LEAST_PIXELS, _TALLEST_M, _WIDEST_M = 150, 0.35, 0.30
_LEG_M = 0.11
"""What goes on out of the picture and is narrower is no leg."""
_FIST_M = 0.075
"""What is no higher, and of the colour of skin or of the sleeves, is a hand."""
_SKIN = np.array([0.385, 0.285])
"""Shares of red and blue: skins differ in brightness much more than in these."""
_SLIM = ("can", "cup", "bottle", "box")
"""On a hand their lower part is hidden, from the side one does not look into them, and a slim one shows so
few pixels there that an edge looks round."""


@dataclass(frozen=True, slots=True)
class HeldOut(InFloat64):
    """Pieces that people hold out.

    Attributes:
        segments: The pieces.
        lowest_m: Height of what each is held up by, shape (k,).
        distinct: Which have another colour than skin and the clothes behind them: those are no parts of arms.
    """

    segments: Segments
    lowest_m: Array
    distinct: tuple[bool, ...]


def in_hands(cloud: Cloud, people: Sequence[SeenPerson], others: Mask, tint: NDArray[np.float32]) -> HeldOut:
    """Pieces that somebody holds out, or before the trunk where their colour tells them from it.

    Args:
        cloud: The points.
        people: Everybody in the picture.
        others: Pixels of surfaces, and of what stands on them.
        tint: As ``smoothed_tint`` gives it.
    """
    labels = np.zeros(cloud.depth_m.shape, dtype=np.int32)
    lowest: list[float] = []
    distinct: list[bool] = []
    all_away = [_away(cloud, person) for person in people]
    nearest = np.minimum.reduce(all_away)
    for person, away in zip(people, all_away, strict=True):
        near = cloud.there & ~others & (away == nearest) & (away < np.float32(_REACH_M))
        near &= (cloud.z > np.float32(_LOWEST_M)) & (cloud.z < np.float32(_HIGHEST_M))
        trunk = near & (away < np.float32(_HELD_OUT_M))
        body = _worn(cloud, trunk, tint)
        unlike = _unlike(tint, body) & (cloud.z < np.float32(_crown_m(person) - _HEAD_M))
        trunk &= ~unlike
        pieces = segment(cloud, near & ~trunk, tint)
        trunk_depth = np.where(trunk, cloud.depth_m, np.float32(_FAR_M))
        beside = np.abs(cv2.erode(trunk_depth, np.ones((5, 5), np.uint8)) - cloud.depth_m) < _JOINED_M
        for number in range(1, pieces.count + 1):
            mask = pieces.labels == number
            if not _has_size_of_thing(cloud, mask) or _is_hand(cloud, mask, tint, body):
                continue
            stands_out = bool(unlike[mask].mean() > 0.5)
            goes_on = _is_clothes(cloud, mask, near) if stands_out else _is_arm(mask, beside)
            if not goes_on:
                lowest.append(float(np.quantile(cloud.z[mask], 0.02)))
                distinct.append(stands_out)
                labels[mask] = len(lowest)
    return HeldOut(Segments(labels, len(lowest)), np.array(lowest), tuple(distinct))


def held(call: Call) -> Call:
    """What a thing on a hand is called: all that is upright and slim looks much the same."""
    if call.kind not in _SLIM:
        return call
    alike = [kind for kind in _SLIM if kind != call.kind]
    return replace(call, alike=tuple(dict.fromkeys((*call.alike, *alike))))


def _has_size_of_thing(cloud: Cloud, mask: Mask) -> bool:
    if int(mask.sum()) < _LEAST_PIXELS:
        return False
    spans = _spans(cloud, mask)
    return max(spans[:2]) < _WIDEST_M and spans[2] < _TALLEST_M


def _spans(cloud: Cloud, mask: Mask) -> list[float]:
    """How far it reaches along x, y, and z."""
    return [float(np.ptp(np.quantile(axis[mask], (0.02, 0.98)))) for axis in (cloud.x, cloud.y, cloud.z)]


def _is_hand(cloud: Cloud, mask: Mask, tint: NDArray[np.float32], body: Sequence[Array]) -> bool:
    if float(np.ptp(np.quantile(cloud.z[mask], (0.02, 0.98)))) > _FIST_M:
        return False
    own = _tint(mask, tint)
    return any(float(np.abs(own - other).max()) < TINT_CHANGE for other in (*body, _SKIN))


def _away(cloud: Cloud, person: SeenPerson) -> NDArray[np.float32]:
    """How far each pixel's point is from somebody's axis, along the floor."""
    x, y = person.odom_T_person[:2, 3].astype(np.float32)
    away: NDArray[np.float32] = np.hypot(cloud.x - x, cloud.y - y)
    return away


def _crown_m(person: SeenPerson) -> float:
    """Above the floor."""
    shape = person.shape
    height_m = shape.size_m[2] if isinstance(shape, Box) else shape.height_m
    return float(person.odom_T_person[2, 3]) + 0.5 * height_m


def _unlike(tint: NDArray[np.float32], body: Sequence[Array]) -> Mask:
    """Pixels of another colour than the clothes and skin."""
    unlike = np.ones(tint.shape[1:], np.bool_)
    for other in (*body, _SKIN):
        off = np.abs(tint - other.astype(np.float32)[:, None, None]).max(axis=0)
        unlike &= off > np.float32(TINT_CHANGE)
    return unlike.repeat(2, axis=0).repeat(2, axis=1)


def _worn(cloud: Cloud, trunk: Mask, tint: NDArray[np.float32]) -> list[Array]:
    """Colours of the clothes, one for each part of the height, shape (2,) each."""
    band = np.where(trunk, np.floor(cloud.z / np.float32(_BAND_M)), -1).astype(np.int32)
    return [_tint(band == number, tint) for number in np.unique(band[trunk])]


def _is_cut(cloud: Cloud, mask: Mask) -> bool:
    """Whether it goes on: lower than anybody holds anything, or out of the picture and as wide as a leg."""
    edge = mask.copy()
    edge[1:-1, 1:-1] = False
    low = cloud.z[mask].min() < _LOWEST_M + _JOINED_M
    return bool(low or (edge.any() and max(_spans(cloud, mask)[:2]) > _LEG_M))


def _is_arm(mask: Mask, beside: Mask) -> bool:
    """Whether it goes on in the trunk, given which pixels are as far away as the trunk right beside them."""
    return int((mask & beside).sum()) > _JOINED_PIXELS


def _is_clothes(cloud: Cloud, mask: Mask, near: Mask) -> bool:
    """Whether it goes on in what is beside it, out of the picture, or below where things are held."""
    return _is_cut(cloud, mask) or _goes_on_share(cloud, mask, near) > _GOES_ON_SHARE


def _goes_on_share(cloud: Cloud, mask: Mask, near: Mask) -> float:
    """Along how much of its edge the depth goes on in what is beside it."""
    edge = mask & (cv2.erode(mask.astype(np.uint8), np.ones((3, 3), np.uint8)) == 0)
    beside = np.where(near & ~mask, cloud.depth_m, np.float32(_FAR_M))
    nearest = cv2.erode(beside, np.ones((5, 5), np.uint8))
    return float((np.abs(nearest - cloud.depth_m)[edge] < np.float32(_GOES_ON_M)).mean())


def _tint(mask: Mask, tint: NDArray[np.float32]) -> Array:
    """The usual one of some pixels, shape (2,)."""
    some = tint[:, mask[::2, ::2]]
    return np.zeros(2) if not some.size else np.median(some, axis=1).astype(np.float64)
