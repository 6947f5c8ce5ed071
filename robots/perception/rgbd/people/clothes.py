"""The colours that people wear, above and below."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from robots.perception.rgbd.colors import Light, brightness, hues
from robots.perception.rgbd.people.body import Body
from robots.perception.rgbd.picture import Colors, Mask
from robots.scenes.scene_words import COLORS

_LEAST_PIXELS = 40
_SURE = 0.55
_FARTHEST = 12.0
_SPREAD = np.array([0.05, 0.05, 0.15])
"""Of the same colour on different people: of its two axes of saturation, and of brightness."""


def clothes_of(body: Body, image: Colors, light: Light) -> tuple[str, ...]:
    """What is worn, "red shirt", "blue trousers", as far as it is seen and the colours have names."""
    upper, lower = _parts(body)
    told = []
    for part, garment in ((upper, "shirt"), (lower, "trousers")):
        color = _color(image, body.pixels[part], light)
        if color is not None:
            told.append(f"{color} {garment}")
    return tuple(told)


def _parts(body: Body) -> tuple[Mask, Mask]:
    """Which points are of the trunk, and which of the legs."""
    points, head = body.points, body.head.middle
    if body.along is not None:
        below = (head[:2] - points[:, :2]) @ body.along
        return (below > 0.32) & (below < 0.60), (below > 0.88) & (below < 1.42)
    below = head[2] - points[:, 2]
    away = np.linalg.norm(points[:, :2] - body.axis, axis=1)
    upper = (below > 0.30) & (below < 0.58) & (away < 0.22)
    if body.posture == "sitting":
        return upper, (below > 0.62) & (below < 1.00) & (away > 0.22) & (away < 0.7)
    return upper, (below > 0.86) & (below < 1.40) & (away < 0.3)


def _color(image: Colors, pixels: NDArray[np.int64], light: Light) -> str | None:
    """The name of the colour of most of some pixels, or None where it cannot be told."""
    if len(pixels) < _LEAST_PIXELS:
        return None
    shown = image[pixels[:, 0], pixels[:, 1]].astype(np.float64)
    # rims are shaded
    bright = shown.sum(axis=1)
    half = shown[bright >= np.median(bright)]
    names, means = _named()
    seen = _measured(np.median(half, axis=0)[None], light)
    off = (((seen - means) / _SPREAD) ** 2).sum(axis=1)
    shares = np.exp(-0.5 * (off - off.min()))
    best = int(off.argmin())
    return names[best] if shares[best] > _SURE * shares.sum() and off[best] < _FARTHEST else None


def _measured(colors: Array, light: Light) -> Array:
    return np.column_stack([hues(colors, light), brightness(colors, light)])


@cache
def _named() -> tuple[tuple[str, ...], Array]:
    """Colour names, and what cloth of each would look like in any light."""
    plain = Light(np.ones(3), 255.0, True)
    return tuple(COLORS), _measured(255.0 * np.array(list(COLORS.values())), plain)
