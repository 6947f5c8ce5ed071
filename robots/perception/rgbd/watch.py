"""Whether pictures are worth looking at: a camera that is frozen, dark or blind says so itself."""

from __future__ import annotations

import zlib
from collections.abc import Mapping
from types import MappingProxyType
from typing import Literal

import cv2
import numpy as np

from robots.perception.rgbd.picture import Picture

Trouble = Literal["frozen", "dark", "no depth", "outshone"]
"""What is wrong with a picture: it is the one before, has no light, hardly any depth, too much light."""

TOLD: Mapping[Trouble, str] = MappingProxyType(
    {
        "frozen": "it shows the same picture again and again",
        "dark": "its picture is too dark, it takes more light",
        "no depth": "it measures hardly any depth",
        "outshone": "its picture is outshone, a light shines into it",
    }
)
"""The same in words."""

_SAME = 3
"""Pictures in a row that are the same to the bit; noise never repeats itself."""
_DARK = 25.0
_LEAST_DEPTH = 0.25
_MOST_WHITE = 0.5
_DIM, _SOME_WHITE, _SOME_LOST = 110.0, 0.12, 0.12
"""Where exposure does what it can, dim light is twice as bright; what is white and what gives no depth is a
few hundredths of a usual picture."""
_EVERY = 8
_IN_REACH_M = 6.0


class PictureWatch:
    """Looks at each picture before anything is looked for in it."""

    def __init__(self) -> None:
        self._last, self._same = 0, 0

    def judge(self, picture: Picture) -> Trouble | None:
        """What is wrong with the newest picture, or None."""
        sample = zlib.crc32(picture.depth_m[::4, ::4].tobytes())
        self._same = self._same + 1 if sample == self._last else 1
        self._last = sample
        if self._same >= _SAME:
            return "frozen"
        there = picture.depth_m[::4, ::4][~picture.own[::4, ::4]] > 0.0
        if there.size > 100 and float(there.mean()) < _LEAST_DEPTH:
            return "no depth"
        if _brightest(picture) < _DARK:
            return "dark"
        if _white(picture) > _MOST_WHITE:
            return "outshone"
        return None

    @staticmethod
    def hindrance(picture: Picture) -> str | None:
        """What makes a picture in which things can be looked for tell less than usual, or None."""
        if _brightest(picture) < _DIM:
            return "its picture is nearly dark"
        if _white(picture) > _SOME_WHITE:
            return "a part of its picture is outshone"
        if _lost(picture) > _SOME_LOST:
            return "it measures no depth in a part of its picture, its lens may be dirty"
        return None


def _brightest(picture: Picture) -> float:
    """How bright the brightest parts are; a dark picture's noise is averaged out of them."""
    height, width = picture.depth_m.shape
    mean = cv2.resize(picture.color, (width // _EVERY, height // _EVERY), interpolation=cv2.INTER_AREA)
    return float(np.percentile(mean.max(axis=2), 95.0))


def _white(picture: Picture) -> float:
    """Share of the picture that is as bright as can be."""
    return float((picture.color[::4, ::4].min(axis=2) > 250).mean())


def _lost(picture: Picture) -> float:
    """Share of the picture without depth, of what must show something in reach: a floor or what is on it."""
    across, down = picture.rays()
    row = picture.odom_T_camera[2, :3]
    falls = -(row[0] * across[None, ::_EVERY] + row[1] * down[::_EVERY, None] + row[2])
    floor_m = float(picture.odom_T_camera[2, 3]) / np.maximum(falls, 1e-6)
    sees = (falls > 0.0) & (floor_m < _IN_REACH_M) & ~picture.own[::_EVERY, ::_EVERY]
    lost = sees & (picture.depth_m[::_EVERY, ::_EVERY] <= 0.0)
    return float(lost.sum() / max(int(sees.sum()), 1))
