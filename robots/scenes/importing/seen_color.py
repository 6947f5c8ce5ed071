"""What colour people would say that an imported thing has, by what is seen of it."""

from __future__ import annotations

import io
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from kinematics.arrays import Array, Sealed
from robots.scenes.scene_words import COLORS

_MOST = 0.65
"""Share of what is seen that a colour must have: of a thing of two colours people say neither."""
_MOST_PX = 1024
_WORDS = tuple(COLORS)
_TO_CONES = np.array(
    [
        [0.4122214708, 0.5363325363, 0.0514459929],
        [0.2119034982, 0.6806995451, 0.1073969566],
        [0.0883024619, 0.2817188376, 0.6299787005],
    ]
)
_TO_LAB = np.array(
    [
        [0.2104542553, 0.7936177850, -0.0040720468],
        [1.9779984951, -2.4285922050, 0.4505937099],
        [0.0259040371, 0.7827717662, -0.8086757660],
    ]
)
"""Oklab: https://bottosson.github.io/posts/oklab/"""


@dataclass(frozen=True, slots=True)
class Surface(Sealed):
    """Some triangles as they are seen.

    Attributes:
        colors: Of each, shape (n, 3): red, green and blue in [0, 1].
        areas: Of each, shape (n,).
    """

    colors: Array
    areas: Array

    @property
    def mean(self) -> tuple[float, float, float]:
        """The colour of all of it together."""
        red, green, blue = np.average(self.colors, axis=0, weights=self.areas).tolist()
        return red, green, blue


def seen_surface(vertices: Array, faces: NDArray[np.signedinteger[Any]], colors: Array) -> Surface:
    """Triangles with the colour of each, shape (n, 3), or of all, shape (3,); none without area."""
    sides = vertices[faces[:, 1:]] - vertices[faces[:, :1]]
    areas = 0.5 * np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1)
    each = np.broadcast_to(colors, (len(faces), 3))
    return Surface(each[areas > 0.0], areas[areas > 0.0])


def on_picture(picture: bytes, places: Array) -> Array:
    """Colours of a picture, PNG, at some places of it, shape (n, 2), from its lower left; it repeats."""
    with Image.open(io.BytesIO(picture)) as file:
        image = np.asarray(file.convert("RGB"), np.float64) / 255.0
    height, width = image.shape[:2]
    across, up = (places % 1.0).T
    columns = np.minimum((across * width).astype(int), width - 1)
    rows = np.minimum(((1.0 - up) * height).astype(int), height - 1)
    return np.asarray(image[rows, columns])


def small_png(image: Image.Image) -> bytes:
    """A picture as it is kept with a thing: PNG, in red, green and blue, of 1024 pixels a side at most."""
    small = image.convert("RGB")
    small.thumbnail((_MOST_PX, _MOST_PX))
    out = io.BytesIO()
    small.save(out, "PNG")
    return out.getvalue()


def said_color(surface: Surface) -> tuple[str, float] | None:
    """The canonical colour that most of it is nearest to, and of what share; None where there is none."""
    if not surface.areas.any():
        return None
    known = _lab(np.array([COLORS[word] for word in _WORDS]))
    away = np.linalg.norm(_lab(surface.colors)[:, None] - known, axis=2)
    shares = np.bincount(away.argmin(axis=1), surface.areas, len(_WORDS)) / surface.areas.sum()
    best = int(shares.argmax())
    return (_WORDS[best], float(shares[best])) if shares[best] >= _MOST else None


def share_of_seen(share: float) -> str:
    """Why a colour was taken, in words."""
    return f"{100.0 * share:.0f} % of what is seen"


def _lab(colors: Array) -> Array:
    """Colours in Oklab, where those that look alike are near each other."""
    linear = np.where(colors <= 0.04045, colors / 12.92, ((colors + 0.055) / 1.055) ** 2.4)
    return np.asarray(np.cbrt(linear @ _TO_CONES.T) @ _TO_LAB.T)
