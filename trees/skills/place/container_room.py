"""The room that a container leaves beside what is put into it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.geometry.shapes import Box, Shape
from kinematics.scene.free_spots import footprint_radius_m

# Left between the object and the walls: a perception error.
_ROOM_M = 0.01


def room_beside_m(container: Shape, thing: Shape) -> NDArray[np.float64]:
    """How far a thing can stand from the middle of a container, along its sides; below 0 it is too wide.

    Args:
        container: Its solid.
        thing: The solid that goes into it, upright, however it is turned.

    Returns:
        Shape (2,), in the container's frame.
    """
    size = container.size_m[:2] if isinstance(container, Box) else (2.0 * footprint_radius_m(container),) * 2
    room: NDArray[np.float64] = np.array(size) * 0.5 - footprint_radius_m(thing) - _ROOM_M
    return room
