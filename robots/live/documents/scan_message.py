"""A range scan as a message, and back; to the millimetre."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Sealed
from robots.live.wire.errors import ProtocolError
from robots.live.wire.messages import write_message

_MOST_POINTS = 2_000
"""A message has 65,536 bytes; of more points the nearest are told."""


@dataclass(frozen=True, slots=True)
class RangeScan(Sealed):
    """What a range sensor saw.

    Attributes:
        stamp_s: Control time.
        points_m: As ``RangeSensor.scan`` gives them, shape (n, 3).
    """

    stamp_s: float
    points_m: NDArray[np.float64]


def write_scan(scan: RangeScan) -> bytes:
    """The payload of a scan."""
    points = scan.points_m
    if len(points) > _MOST_POINTS:
        points = points[np.argsort(np.hypot(points[:, 0], points[:, 1]), kind="stable")[:_MOST_POINTS]]
    millimetres = np.rint(1e3 * points).astype(int)
    return write_message("scan", stamp_s=scan.stamp_s, points_mm=millimetres.ravel().tolist())


def read_scan(document: Mapping[str, Any]) -> RangeScan:
    """The scan of a message.

    Raises:
        ProtocolError: It is none.
    """
    try:
        points = np.array(document["points_mm"], dtype=np.float64).reshape(-1, 3)
        return RangeScan(float(document["stamp_s"]), 1e-3 * points)
    except (KeyError, TypeError, ValueError) as wrong:
        raise ProtocolError(f"a scan that is none: {wrong!r}") from None
