"""Colour names of things, whatever the light: what is white is found by a surface of known colour."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, InFloat64
from robots.perception.rgbd.cloud import Cloud
from robots.perception.rgbd.color_classes import COLOR_NAMES, DEVIATIONS, HUE_PRECISIONS, MEANS
from robots.perception.rgbd.picture import Colors, Mask, window_of

REFERENCE_RGB = (0.62, 0.47, 0.32)
"""Of the wood that furniture is made of, in daylight."""
_WARMEST = np.array([1.0, 0.70, 0.38])
"""Of a filament lamp, warmer than usual ones; light is between this and daylight."""
_LEAST_REFERENCE = 400
_OFF_LOCUS = 0.08
_WHITE = 235.0
_LEAST_PIXELS = 8
_NEIGHBOURS_PX = 8
"""Of a pixel so far around it tells how it faces."""
_SHARES = 0.5, 0.95, 0.75, 0.95
"""Of pixels in order of brightness: from where to where are those that count as typical, and as bright."""
_LEVEL, _UPRIGHT = 0.92, 0.5
"""What faces upwards by more than the one is level, by less than the other upright."""
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


def hues(shown: Array, light: Light) -> Array:
    """Two axes of saturation, shape (k, 2): how much of red, and of blue, there is.

    Args:
        shown: Colours in the picture, in [0, 255], shape (k, 3).
        light: Of the picture.
    """
    reflected = _reflected(shown, light)
    total = reflected.sum(axis=1) + 0.06
    return np.column_stack([(reflected[:, 0] + 0.02) / total, (reflected[:, 2] + 0.02) / total])


def brightness(shown: Array, light: Light) -> Array:
    """How bright colours are beside what reflects everything, on a scale of logarithms, shape (k,)."""
    found: Array = 0.35 * np.log(_reflected(shown, light).mean(axis=1) + 0.03)
    return found


def _reflected(shown: Array, light: Light) -> Array:
    found: Array = np.maximum(shown, 0.0) / light.tint / max(light.level, 1.0)
    return found


def features(pieces: PieceColors, light: Light) -> Array:
    """What tells colours apart, shape (k, 4): hues, and brightness of what is level and of what is upright.

    A brightness that nothing of a piece shows is nan.
    """
    values = np.column_stack(
        [hues(pieces.typical, light), brightness(pieces.level, light), brightness(pieces.upright, light)]
    )
    values[~pieces.has_level, 2] = np.nan
    values[~pieces.has_upright, 3] = np.nan
    return values


def as_in_daylight(color: Colors, light: Light) -> Colors:
    """The picture as it would be in usual light, in which white is just below the brightest."""
    steps = np.arange(256, dtype=np.float64)[:, None] / light.tint / max(light.level, 1.0)
    table = np.clip(_WHITE * steps + 0.5, 0.0, 255.0).astype(np.uint8)
    return np.asarray(cv2.LUT(color, table[None]))


def facing_up(cloud: Cloud, shown: Mask) -> NDArray[np.float32]:
    """How much each two by two pixels face upwards: 1 level, 0 upright, nan where their neighbours are lost.

    Args:
        cloud: The points.
        shown: For which of them that is asked.

    Returns:
        Shape (height / 2, width / 2); nan too far beside those that are asked.
    """
    rows, columns = window_of(shown, _NEIGHBOURS_PX)
    part = (slice(rows.start, rows.stop, 2), slice(columns.start, columns.stop, 2))
    places = cv2.merge([cloud.x[part], cloud.y[part], cloud.z[part]])
    smooth = cv2.blur(places, (3, 3))
    across, down = np.zeros_like(smooth), np.zeros_like(smooth)
    across[:, 1:-1] = smooth[:, 2:] - smooth[:, :-2]
    down[1:-1] = smooth[2:] - smooth[:-2]
    ax, ay, az = cv2.split(across)
    dx, dy, dz = cv2.split(down)
    nx, ny, nz = ay * dz - az * dy, az * dx - ax * dz, ax * dy - ay * dx
    size = np.sqrt(nx * nx + ny * ny + nz * nz)
    whole = cv2.erode(cloud.there[part].astype(np.uint8), np.ones((5, 5), np.uint8)) > 0
    up = np.abs(nz) / np.maximum(size, np.float32(1e-12))
    found = np.full(cloud.there[::2, ::2].shape, np.nan, dtype=np.float32)
    found[rows.start // 2 : (rows.stop + 1) // 2, columns.start // 2 : (columns.stop + 1) // 2] = np.where(
        whole & (size > 0.0), up, np.float32(np.nan)
    )
    return found


@dataclass(frozen=True, slots=True)
class PieceColors(InFloat64):
    """What colours k pieces of a picture show, each in [0, 255], shape (k, 3).

    What is level is lit as the surface is by which the light is known; what is upright may be in shade.

    Attributes:
        typical: The median of the brighter half.
        level: The brighter ones of what faces upwards.
        upright: The brighter ones of all else.
        used: How many pixels that goes by, shape (k,).
        has_level, has_upright: Whether enough of it is seen to tell, shape (k,).
    """

    typical: Array
    level: Array
    upright: Array
    used: Array
    has_level: NDArray[np.bool_]
    has_upright: NDArray[np.bool_]


def piece_colors(
    color: Colors, labels: NDArray[np.int32], count: int, up: NDArray[np.float32]
) -> PieceColors:
    """What colours the pieces have, without their rims.

    Args:
        color: The picture.
        labels: To which piece each pixel belongs, from 1.
        count: Of pieces.
        up: As ``facing_up`` tells.
    """
    height, width = labels.shape
    half = cv2.resize(color, (width // 2, height // 2), interpolation=cv2.INTER_AREA)
    half, labels = cv2.blur(half, (3, 3)), labels[::2, ::2]
    inner = cv2.erode((labels > 0).astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
    typical, level, upright = np.zeros((count, 3)), np.zeros((count, 3)), np.zeros((count, 3))
    used = np.zeros(count)
    has_level, has_upright = np.zeros(count, np.bool_), np.zeros(count, np.bool_)
    # the inner part where there is one
    enough = np.bincount(labels[inner], minlength=count + 1) >= _LEAST_PIXELS
    rows, columns = np.nonzero((labels > 0) & (inner | ~enough[labels]))
    which = labels[rows, columns] - 1
    pixels = half[rows, columns].astype(np.float64)
    facing = up[rows, columns]
    order = np.lexsort((pixels @ np.ones(3), which))
    which, pixels, facing = which[order], pixels[order], facing[order]
    first = np.searchsorted(which, np.arange(count))
    last = np.searchsorted(which, np.arange(count), side="right")
    for k in range(count):
        some, faces = pixels[first[k] : last[k]], facing[first[k] : last[k]]
        if len(some) < _LEAST_PIXELS:
            continue
        at = [int(share * len(some)) for share in _SHARES]
        typical[k] = np.median(some[at[0] : at[1]], axis=0)
        used[k] = len(some)
        has_level[k], level[k] = _brighter(some[faces > _LEVEL])
        has_upright[k], upright[k] = _brighter(some[faces < _UPRIGHT])
    return PieceColors(typical, level, upright, used, has_level, has_upright)


def _brighter(pixels: Array) -> tuple[bool, Array]:
    """Whether there are enough, and the mean of the brighter ones of some in order of brightness."""
    if len(pixels) < _LEAST_PIXELS:
        return False, np.zeros(3)
    found: Array = pixels[int(_SHARES[2] * len(pixels)) : int(_SHARES[3] * len(pixels)) + 1].mean(axis=0)
    return True, found


def name_colors(values: Array) -> tuple[list[str], Array, Array]:
    """The nearest colour name of each, its probability, and its distance squared, in deviations.

    Args:
        values: As ``features`` gives them, shape (k, 4).
    """
    off = values[:, None] - MEANS
    by_hue = np.einsum("kci,cij,kcj->kc", off[..., :2], HUE_PRECISIONS, off[..., :2])
    known = np.isfinite(off[..., 2:])
    by_brightness = np.square(np.where(known, off[..., 2:], 0.0) / DEVIATIONS).sum(axis=2)
    away = by_hue + by_brightness
    # of a brightness that is not known each name is as likely as before
    told = away - _LOG_PRECISIONS + 2.0 * np.where(known, np.log(DEVIATIONS), 0.0).sum(axis=2)
    shares = np.exp(-0.5 * (told - told.min(axis=1, keepdims=True)))
    shares /= shares.sum(axis=1, keepdims=True)
    best = told.argmin(axis=1)
    rows = np.arange(len(values))
    return [COLOR_NAMES[i] for i in best], shares[rows, best], away[rows, best]


_LOG_PRECISIONS = np.linalg.slogdet(HUE_PRECISIONS)[1]
