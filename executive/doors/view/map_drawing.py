"""The rooms of the robot's map, in the page: outlines on the floor, with their names."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import viser
from numpy.typing import NDArray

_OUTLINE = (120, 120, 150)
_ABOVE_M = 0.002

Floats = NDArray[np.float64]


def corners_of(room: Mapping[str, Any]) -> Floats:
    """Corners of a room on the floor, shape (4, 2), in the odometry frame.

    Args:
        room: As the executive tells it (``world`` of docs/reference/live-protocol.md).
    """
    half = 0.5 * np.array(room["size_m"])
    signs = np.array([[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]])
    c, s = math.cos(room["yaw_rad"]), math.sin(room["yaw_rad"])
    corners: Floats = signs * half @ np.array([[c, s], [-s, c]]) + np.array(room["middle_m"])
    return corners


class MapDrawing:
    """Draws the rooms; they are drawn once, for the map does not change.

    Args:
        scene: Of the page.
    """

    def __init__(self, scene: viser.SceneApi) -> None:
        self._scene = scene
        self._drawn: Sequence[Mapping[str, Any]] = ()

    def show(self, rooms: Sequence[Mapping[str, Any]]) -> None:
        """Draw these rooms."""
        if list(rooms) == list(self._drawn):
            return
        self._drawn = rooms
        for room in rooms:
            ring = np.column_stack([corners_of(room), np.full(4, _ABOVE_M)]).astype(np.float32)
            ends = np.stack([ring, np.roll(ring, -1, axis=0)], axis=1)
            name = f"/map/{room['name']}"
            self._scene.add_line_segments(name, ends, _OUTLINE, thickness=0.03)
            x, y = room["middle_m"]
            self._scene.add_label(f"{name}/name", str(room["name"]), position=(float(x), float(y), 0.05))
