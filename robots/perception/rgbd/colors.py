"""Colour names of things, whatever the light: what is white is found by a surface of known colour."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, InFloat64
from robots.perception.rgbd.color_classes import COLOR_NAMES, MEANS, PRECISIONS
from robots.perception.rgbd.picture import Colors, Mask

REFERENCE_RGB = (0.62, 0.47, 0.32)
"""Of the wood that furniture is made of, in daylight."""
_WARMEST = np.array([1.0, 0.70, 0.38])
"""Of a filament lamp, warmer than usual ones; light is between this and daylight."""
_LEAST_REFERENCE = 400
_OFF_LOCUS = 0.08
_WHITE = 235.0
_LEAST_PIXELS = 8
_SHARES = 0.5, 0.95, 0.82, 0.95
"""Of pixels in order of brightness: from where to where are those that count as typical, and as bright."""
_DARK = 20.0


@dataclass(frozen=True, slots=True)
class Light(InFloat64):
    """The light of a picture, as a surface of known colour tells it.

    Attributes:
        tint: Of red, green, blue, relative to daylight.
        level: How bright a thing is in the picture that reflects everything, in [0, 255].
        known: Whether the surface was one of known colour.
    """

    tint: Array
    level: float
    known: bool


def smoothed_tint(color: Colors) -> NDArray[np.float32]:
    """Shares of red and blue, smoothed, of each two by two pixels; dark ones tend to grey.

    Returns:
        Shape (2, height / 2, width / 2).
    """
    height, width = color.shape[:2]
    half = cv2.resize(color, (width // 2, height // 2), interpolation=cv2.INTER_AREA)
    red, green, blue = cv2.split(cv2.blur(half, (3, 3)).astype(np.float32))
    grey = np.float32(_DARK)
    total = red + green + blue + np.float32(3.0 * _DARK)
    return np.stack([(red + grey) / total, (blue + grey) / total])


def light_of(
    color: Colors, surface: Mask | None, reference: tuple[float, float, float] = REFERENCE_RGB
) -> Light:
    """What the light is like.

    Args:
        color: The picture.
        surface: Where it shows the largest surface that carries things, of every second row and column.
        reference: The colour of that surface in daylight.
    """
    wood = np.array(reference)
    bright = float(np.percentile(color[::8, ::8].max(axis=2), 99.0))
    unknown = Light(np.ones(3), max(bright, 1.0), False)
    if surface is None or int(surface.sum()) < _LEAST_REFERENCE:
        return unknown
    shown = np.median(color[::2, ::2][surface][::7], axis=0) + 1.0
    ratio = shown / wood
    ratio /= ratio[0]
    shares = np.linspace(-0.15, 1.0, 47)[:, None]
    locus = np.exp(shares * np.log(_WARMEST)[None])
    off = np.abs(np.log(ratio)[None] - np.log(locus)).max(axis=1)
    best = int(off.argmin())
    if off[best] > 3.0 * _OFF_LOCUS:
        return unknown
    return Light(locus[best], float(shown[0] / wood[0]), True)


def features(typical: Array, bright: Array, light: Light) -> Array:
    """What tells colours apart: two axes of saturation, and two of brightness, shape (k, 4).

    Args:
        typical, bright: Colours of things and of their brightest parts in [0, 255], shape (k, 3).
        light: Of the picture.
    """
    seen, best = (
        np.maximum(pixels, 0.0) / light.tint / max(light.level, 1.0) for pixels in (typical, bright)
    )
    total = seen.sum(axis=1) + 0.06
    return np.column_stack(
        [
            (seen[:, 0] + 0.02) / total,
            (seen[:, 2] + 0.02) / total,
            0.35 * np.log(seen.mean(axis=1) + 0.03),
            0.35 * np.log(best.mean(axis=1) + 0.03),
        ]
    )


def as_in_daylight(color: Colors, light: Light) -> Colors:
    """The picture as it would be in usual light, in which white is just below the brightest."""
    steps = np.arange(256, dtype=np.float64)[:, None] / light.tint / max(light.level, 1.0)
    table = np.clip(_WHITE * steps + 0.5, 0.0, 255.0).astype(np.uint8)
    return np.asarray(cv2.LUT(color, table[None]))


def typical_colors(color: Colors, labels: NDArray[np.int32], count: int) -> tuple[Array, Array, Array]:
    """What colour each piece has, without its rim.

    Returns:
        The median colour of its brighter half, that of its brightest parts but for the very brightest, both
        in [0, 255], shape (k, 3), and how many pixels that goes by, shape (k,).
    """
    height, width = labels.shape
    half = cv2.resize(color, (width // 2, height // 2), interpolation=cv2.INTER_AREA)
    half, labels = cv2.blur(half, (3, 3)), labels[::2, ::2]
    inner = cv2.erode((labels > 0).astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
    typical, bright, used = np.zeros((count, 3)), np.zeros((count, 3)), np.zeros(count)
    for mask in (labels > 0, inner):  # the inner part where there is one
        rows, columns = np.nonzero(mask)
        which = labels[rows, columns] - 1
        pixels = half[rows, columns].astype(np.float64)
        order = np.lexsort((pixels @ np.ones(3), which))
        which, pixels = which[order], pixels[order]
        first = np.searchsorted(which, np.arange(count))
        last = np.searchsorted(which, np.arange(count), side="right")
        for k in range(count):
            some = pixels[first[k] : last[k]]
            if len(some) >= _LEAST_PIXELS:
                at = [int(share * len(some)) for share in _SHARES]
                typical[k] = np.median(some[at[0] : at[1]], axis=0)
                bright[k] = some[at[2] : at[3]].mean(axis=0)
                used[k] = len(some)
    return typical, bright, used


def name_colors(values: Array) -> tuple[list[str], Array, Array]:
    """The nearest colour name of each, its probability, and its distance squared, in deviations.

    Args:
        values: As ``features`` gives them, shape (k, 4).
    """
    off = values[:, None] - MEANS
    away = np.einsum("kci,cij,kcj->kc", off, PRECISIONS, off)
    told = away - _LOG_PRECISIONS
    shares = np.exp(-0.5 * (told - told.min(axis=1, keepdims=True)))
    shares /= shares.sum(axis=1, keepdims=True)
    best = told.argmin(axis=1)
    rows = np.arange(len(values))
    return [COLOR_NAMES[i] for i in best], shares[rows, best], away[rows, best]


_LOG_PRECISIONS = np.linalg.slogdet(PRECISIONS)[1]
