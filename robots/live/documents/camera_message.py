"""The cameras of a room, as the control process tells of them when it is greeted, and back."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

import numpy as np

from robots.live.wire.errors import ProtocolError
from robots.perception.detector import Detector
from robots.perception.fusion.cameras import PlacedCamera


def cameras_json(cameras: Iterable[PlacedCamera]) -> list[dict[str, Any]]:
    """Where they are, and what they show."""
    return [
        {
            "name": camera.name,
            "odom_T_camera": camera.odom_T_camera.ravel().tolist(),
            "field_of_view_rad": camera.field_of_view_rad,
            "range_m": camera.range_m,
        }
        for camera in cameras
    ]


def cameras_of(
    documents: Iterable[Mapping[str, Any]], detector: Callable[[str], Detector]
) -> tuple[PlacedCamera, ...]:
    """The cameras of a welcome.

    Args:
        documents: What was told of each.
        detector: Makes the source of the frames of a camera, by its name.

    Raises:
        ProtocolError: They are none.
    """
    try:
        return tuple(
            PlacedCamera(
                str(one["name"]),
                detector(str(one["name"])),
                np.array(one["odom_T_camera"], dtype=np.float64).reshape(4, 4),
                _pair(one["field_of_view_rad"]),
                _pair(one["range_m"]),
            )
            for one in documents
        )
    except (KeyError, TypeError, ValueError) as wrong:
        raise ProtocolError(f"a camera that is none: {wrong!r}") from None


def _pair(values: Any) -> tuple[float, float]:
    first, second = values
    return float(first), float(second)
