"""What people hold out: things in the air, ahead of somebody's trunk, on a hand."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import cv2
import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from robots.perception.rgbd.cloud import Cloud
from robots.perception.rgbd.labels import Call
from robots.perception.rgbd.people.find import SeenPerson
from robots.perception.rgbd.picture import Mask
from robots.perception.rgbd.segments import TINT_CHANGE, Segments, segment

_REACH_M = 1.2
"""Nobody holds anything farther from the axis of the trunk."""
_LOWEST_M, _HIGHEST_M = 0.5, 1.7
_HELD_OUT_M = 0.27
"""What is nearer to the axis than this is trunk, or an arm that hangs."""
_JOINED_PIXELS, _JOINED_M = 8, 0.03
_FAR_M = 100.0
_LEAST_PIXELS, _TALLEST_M, _WIDEST_M = 150, 0.35, 0.30
_FIST_M = 0.075
"""What is no higher, and of the colour of skin or of the sleeves, is a hand."""
_SKIN = (0.385, 0.285)
"""Shares of red and blue: skins differ in brightness much more than in these."""
_SLIM = ("can", "cup", "bottle", "box")
"""On a hand their lower part is hidden, from the side one does not look into them, and a slim one shows so
few pixels there that an edge looks round."""


def in_hands(
    cloud: Cloud, people: Sequence[SeenPerson], others: Mask, tint: NDArray[np.float32]
) -> tuple[Segments, Array]:
    """Pieces that somebody holds out, and the height of what each is held up by, shape (k,).

    Args:
        cloud: The points.
        people: Everybody in the picture.
        others: Pixels of surfaces, and of what stands on them.
        tint: As ``smoothed_tint`` gives it.
    """
    labels = np.zeros(cloud.depth_m.shape, dtype=np.int32)
    lowest: list[float] = []
    for person in people:
        axis = person.odom_T_person[:2, 3].astype(np.float32)
        away = np.hypot(cloud.x - axis[0], cloud.y - axis[1])
        near = cloud.there & ~others & (labels == 0) & (away < np.float32(_REACH_M))
        near &= (cloud.z > np.float32(_LOWEST_M)) & (cloud.z < np.float32(_HIGHEST_M))
        trunk = near & (away < np.float32(_HELD_OUT_M))
        pieces = segment(cloud, near & ~trunk, tint)
        body = _tint(trunk, tint)
        trunk_depth = np.where(trunk, cloud.depth_m, np.float32(_FAR_M))
        beside = np.abs(cv2.erode(trunk_depth, np.ones((5, 5), np.uint8)) - cloud.depth_m) < _JOINED_M
        for number in range(1, pieces.count + 1):
            mask = pieces.labels == number
            if int((mask & beside).sum()) > _JOINED_PIXELS or not _has_size_of_thing(cloud, mask):
                continue  # an arm goes on in the trunk
            if not _is_hand(cloud, mask, tint, body):
                lowest.append(float(np.quantile(cloud.z[mask], 0.02)))
                labels[mask] = len(lowest)
    return Segments(labels, len(lowest)), np.array(lowest)


def held(call: Call) -> Call:
    """What a thing on a hand is called: all that is upright and slim looks much the same."""
    if call.kind not in _SLIM:
        return call
    alike = [kind for kind in _SLIM if kind != call.kind]
    return replace(call, alike=tuple(dict.fromkeys((*call.alike, *alike))))


def _has_size_of_thing(cloud: Cloud, mask: Mask) -> bool:
    if int(mask.sum()) < _LEAST_PIXELS:
        return False
    spans = [float(np.ptp(np.quantile(axis[mask], (0.02, 0.98)))) for axis in (cloud.x, cloud.y, cloud.z)]
    return max(spans[:2]) < _WIDEST_M and spans[2] < _TALLEST_M


def _is_hand(cloud: Cloud, mask: Mask, tint: NDArray[np.float32], body: Array) -> bool:
    if float(np.ptp(np.quantile(cloud.z[mask], (0.02, 0.98)))) > _FIST_M:
        return False
    own = _tint(mask, tint)
    return any(float(np.abs(own - other).max()) < TINT_CHANGE for other in (body, np.array(_SKIN)))


def _tint(mask: Mask, tint: NDArray[np.float32]) -> Array:
    """The usual one of some pixels, shape (2,)."""
    some = tint[:, mask[::2, ::2]]
    return np.zeros(2) if not some.size else np.median(some, axis=1).astype(np.float64)
