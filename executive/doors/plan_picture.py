"""A picture of what the robot believes to be around it, from above; no truth of a simulator is in it."""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from typing import Any

_SIZE = 640
"""Pixels of a side."""
_LEAST_M, _MOST_M = 2.0, 12.0
"""Half the side in metres: as far as things are, within these bounds."""
_PAPER, _GRID, _INK, _ROBOT = "#ffffff", "#e4e7eb", "#22262b", "#2f6fde"
_KINDS = {"object": "#d9822b", "furniture": "#8a97a6", "person": "#1f9d63"}
_COLORS = frozenset(
    ("red", "green", "blue", "yellow", "orange", "white", "black", "gray", "brown", "purple", "pink", "cyan")
)


def plan_picture(things: Sequence[Mapping[str, Any]]) -> bytes:
    """Draw a scene as a PNG; the robot is in the middle and looks to the top.

    Args:
        things: As a served executive tells its scene: place and radius in metres from below the base.
    """
    from PIL import Image, ImageDraw

    placed = [one for one in things if "place_m" in one]
    far = max((max(abs(one["place_m"][0]), abs(one["place_m"][1])) for one in placed), default=_LEAST_M)
    half_m = min(max(far + 0.5, _LEAST_M), _MOST_M)
    scale = _SIZE / (2.0 * half_m)

    def pixel(place: Sequence[float]) -> tuple[float, float]:
        return _SIZE / 2.0 - place[1] * scale, _SIZE / 2.0 - place[0] * scale

    image = Image.new("RGB", (_SIZE, _SIZE), _PAPER)
    draw = ImageDraw.Draw(image)
    for metre in range(-int(half_m), int(half_m) + 1):
        across, along = pixel((metre, 0.0))[1], pixel((0.0, metre))[0]
        draw.line([(0, across), (_SIZE, across)], fill=_GRID)
        draw.line([(along, 0), (along, _SIZE)], fill=_GRID)
    draw.polygon([pixel((0.35, 0.0)), pixel((-0.15, 0.2)), pixel((-0.15, -0.2))], fill=_ROBOT)
    rank = {"furniture": 0, "person": 1, "object": 2}
    for one in sorted(placed, key=lambda each: rank.get(str(each["is"]), 0)):
        x, y = pixel(one["place_m"])
        radius = max(float(one.get("radius_m", 0.05)) * scale, 3.0)
        color = one.get("color") if one.get("color") in _COLORS else _KINDS.get(str(one["is"]), _INK)
        box = (x - radius, y - radius, x + radius, y + radius)
        draw.ellipse(box, outline=_INK, fill=None if one["is"] == "furniture" else color)
        draw.text((x + radius + 2, y - 6), str(one["words"])[:40], fill=_INK)
    held = ", ".join(str(one["words"]) for one in things if one.get("held"))
    draw.text((8, 8), f"held: {held}" if held else "hands empty", fill=_INK)
    stored = io.BytesIO()
    image.save(stored, "PNG")
    return stored.getvalue()
