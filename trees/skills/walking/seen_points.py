"""Where a range sensor has seen something, kept while the robot walks."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry.planar import PlanarPose
from kinematics.walking.route.path_planning import Footprint
from robots.perception.detector import RangeSensor

_CELL_M = 0.05
_KNOWN_M = 0.12
"""A point this near to something known is a point of it."""


class SeenPoints:
    """Where the range sensor has seen obstacles, as points on a grid over the floor, in the odometry frame.

    Attributes:
        silent: Whether the sensor had no reading when it was asked last.
    """

    def __init__(self, sensor: RangeSensor | None) -> None:
        """Nothing was seen yet; without a sensor nothing ever is."""
        self._sensor = sensor
        self.silent = False
        self._tops_m: dict[tuple[int, int], float] = {}

    def look(self, body: PlanarPose, leave_out: Callable[[Array], Array] = lambda scan: scan) -> Array:
        """Take a scan; gives the points that are new, shape (n, 2).

        Args:
            body: Where the base is.
            leave_out: Takes out of a scan, shape (n, 3), what is no obstacle.
        """
        scan = None if self._sensor is None else self._sensor.scan()
        self.silent = self._sensor is not None and scan is None
        if scan is None:
            return np.zeros((0, 2))
        scan = leave_out(scan)
        c, s = math.cos(body.yaw_rad), math.sin(body.yaw_rad)
        x = body.x_m + c * scan[:, 0] - s * scan[:, 1]
        y = body.y_m + s * scan[:, 0] + c * scan[:, 1]
        new: dict[tuple[int, int], None] = {}
        columns, rows = np.rint(x / _CELL_M).astype(int), np.rint(y / _CELL_M).astype(int)
        for cell, top_m in zip(zip(columns.tolist(), rows.tolist(), strict=True), scan[:, 2], strict=True):
            if cell not in self._tops_m:
                new[cell] = None
            self._tops_m[cell] = max(float(top_m), self._tops_m.get(cell, -math.inf))
        return _places(new)

    def beside(self, known: Iterable[Footprint], above_m: float = -math.inf) -> Array:
        """All points that belong to nothing that is known, shape (n, 2).

        Args:
            known: What is.
            above_m: Only where something was seen at this height over the floor, or higher.
        """
        return apart_from(_places(cell for cell, top in self._tops_m.items() if top >= above_m), known)


def apart_from(points: Array, known: Iterable[Footprint]) -> Array:
    """Those points, shape (n, 2), that are no points of something known."""
    for footprint in known:
        if len(points):
            points = points[footprint.distance_m(points) > _KNOWN_M]
    return points


def _places(cells: Iterable[tuple[int, int]]) -> Array:
    return _CELL_M * np.array(list(cells), dtype=np.float64).reshape(-1, 2)
