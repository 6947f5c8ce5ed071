"""Whether pictures are worth looking at: a camera that is frozen, dark or blind says so itself."""

from __future__ import annotations

import zlib
from collections.abc import Mapping
from types import MappingProxyType
from typing import Literal

import numpy as np

from robots.perception.rgbd.picture import Picture

Trouble = Literal["frozen", "dark", "no depth", "outshone"]
"""What is wrong with a picture: it is the one before, has no light, hardly any depth, too much light."""

TOLD: Mapping[Trouble, str] = MappingProxyType(
    {
        "frozen": "the camera shows the same picture again and again",
        "dark": "the picture is too dark",
        "no depth": "the camera measures hardly any depth",
        "outshone": "the picture is outshone",
    }
)
"""The same in words."""

_SAME = 3
"""Pictures in a row that are the same to the bit; noise never repeats itself."""
_DARK = 25.0
_LEAST_DEPTH = 0.25
_MOST_WHITE = 0.5


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
        thin = picture.color[::4, ::4]
        there = picture.depth_m[::4, ::4][~picture.own[::4, ::4]] > 0.0
        if there.size > 100 and float(there.mean()) < _LEAST_DEPTH:
            return "no depth"
        brightest = float(np.percentile(thin.max(axis=2), 95.0))
        if brightest < _DARK:
            return "dark"
        if float((thin.min(axis=2) > 250).mean()) > _MOST_WHITE:
            return "outshone"
        return None
