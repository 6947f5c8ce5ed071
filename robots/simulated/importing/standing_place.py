"""Where a robot may begin in a foreign scene: before a top, looking at it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

_BEFORE_M = (0.42, 0.55, 0.8, 1.2)
"""From the edge of a table to who stands before it, the nearest first."""
_SIDES = (0.0, math.pi, 0.5 * math.pi, -0.5 * math.pi)


def starts_before(tops: Sequence[Mapping[str, Any]]) -> Iterator[tuple[float, float, float] | None]:
    """Places and headings, x, y in m and yaw in rad; first None where there is no furniture.

    Args:
        tops: Pieces of furniture, as a scene file has them.
    """
    if not tops:
        yield None
    for top in sorted(tops, key=lambda one: -float(one["size_m"][0] * one["size_m"][1])):
        x, y = top["position_m"]
        for before in _BEFORE_M:
            for side in _SIDES:
                yaw = top["yaw_rad"] + side
                across = abs(math.sin(side)) > 0.5
                away = 0.5 * top["size_m"][1 if across else 0] + before
                yield x - away * math.cos(yaw), y - away * math.sin(yaw), math.remainder(yaw, 2.0 * math.pi)
