"""What a view of a thing looks like, in numbers: colours by height, and local features."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, InFloat64
from robots.perception.labels.views import View

TALL_PX = 192
"""Views are compared at this height."""
_MOST_TIMES = 4.0
BANDS = 5
_BINS = 6
_MOST_POINTS = 160

Vectors = NDArray[np.float32]


@dataclass(frozen=True, slots=True)
class Look(InFloat64):
    """One view in numbers.

    Attributes:
        colors: Shares of colours in bands from the top to the bottom, of unit sum each, shape (BANDS, n).
        points: Descriptors of local features, of unit length, shape (m, 128).
        places: Where they are: shares of the height and of the width, from the upper left, shape (m, 2).
    """

    colors: Array
    points: Vectors
    places: Vectors


def look_of(view: View, sift: cv2.SIFT) -> Look:
    """Describe a view.

    Args:
        view: What is described.
        sift: Finds and describes local features.
    """
    rows = np.flatnonzero(view.mask.any(axis=1))
    columns = np.flatnonzero(view.mask.any(axis=0))
    top, bottom = int(rows[0]), int(rows[-1]) + 1
    left, right = int(columns[0]), int(columns[-1]) + 1
    color, mask = view.color[top:bottom, left:right], view.mask[top:bottom, left:right]
    times = min(TALL_PX / (bottom - top), _MOST_TIMES)
    size = max(round(times * (right - left)), 8), max(round(times * (bottom - top)), 8)
    large = cv2.resize(color, size, interpolation=cv2.INTER_CUBIC)
    shown = cv2.resize(mask.astype(np.uint8), size, interpolation=cv2.INTER_NEAREST)
    inner = cv2.erode(shown, np.ones((5, 5), np.uint8))
    if not inner.any():
        inner = shown
    found, vectors = sift.detectAndCompute(cv2.cvtColor(large, cv2.COLOR_RGB2GRAY), inner)
    if vectors is None:
        vectors, places = np.zeros((0, 128), np.float32), np.zeros((0, 2), np.float32)
    else:
        strongest = np.argsort([-one.response for one in found], kind="stable")[:_MOST_POINTS]
        vectors = vectors[strongest]
        places = np.array(
            [(found[i].pt[1] / size[1], found[i].pt[0] / size[0]) for i in strongest], np.float32
        )
        # the root of a histogram: its Euclidean distance is that of Hellinger (Arandjelovic, Zisserman 2012)
        vectors = np.sqrt(vectors / np.maximum(vectors.sum(axis=1, keepdims=True), 1e-6))
    return Look(_colors(large, inner > 0), vectors, places)


def finder() -> cv2.SIFT:
    """What finds local features in small pictures of little contrast."""
    return cv2.SIFT.create(nfeatures=0, nOctaveLayers=4, contrastThreshold=0.012, edgeThreshold=14)


def _colors(color: NDArray[np.uint8], mask: NDArray[np.bool_]) -> Array:
    """Shares of colours, each pixel shared among its nearest bins."""
    lab = cv2.cvtColor(cv2.GaussianBlur(color, (0, 0), 1.5), cv2.COLOR_RGB2LAB).astype(np.float32)
    rows = np.broadcast_to(np.arange(len(color))[:, None], mask.shape)
    band = np.minimum(rows[mask] * BANDS // len(color), BANDS - 1)
    # lightness is less sure than hue, and most hues lie near grey
    values = np.stack(
        [
            lab[mask][:, 0] / np.float32(255.0) * np.float32(_BINS - 1),
            _spread(lab[mask][:, 1]),
            _spread(lab[mask][:, 2]),
        ],
        axis=1,
    )
    low = np.clip(np.floor(values), 0, _BINS - 2).astype(np.int64)
    share = np.clip(values - low, 0.0, 1.0)
    total = np.zeros((BANDS, _BINS**3))
    for corner in range(8):
        bits = np.array([corner >> 2 & 1, corner >> 1 & 1, corner & 1])
        weight = np.where(bits > 0, share, 1.0 - share).prod(axis=1)
        place = low + bits
        index = (place[:, 0] * _BINS + place[:, 1]) * _BINS + place[:, 2]
        total += np.bincount(band * _BINS**3 + index, weight, minlength=BANDS * _BINS**3).reshape(total.shape)
    return np.asarray(total / np.maximum(total.sum(axis=1, keepdims=True), 1.0))


def _spread(values: NDArray[np.float32]) -> NDArray[np.float32]:
    off = (values - np.float32(128.0)) / np.float32(64.0)
    return np.asarray((np.clip(np.sign(off) * np.sqrt(np.abs(off)), -1.0, 1.0) + 1.0) * 0.5 * (_BINS - 1))
