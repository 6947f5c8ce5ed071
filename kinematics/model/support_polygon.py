"""The area that the centre of mass may stand over."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from kinematics.arrays import Array
from kinematics.errors import KinematicsError, UnknownNameError
from kinematics.model.robot_description import SoleDescription
from kinematics.model.stance import Stance


class SupportPolygon:
    """The convex hull, on the floor, of the soles that carry.

    A robot without soles is welded to what carries it and cannot tip: its margins are infinite.

    Attributes:
        vertices_m: Corners, counter-clockwise seen from above, shape (n, 2); (0, 2) when welded.
    """

    def __init__(self, stance: Stance, soles: Sequence[SoleDescription]) -> None:
        """Span the polygon.

        Args:
            stance: Where the soles stand.
            soles: The robot's soles, with the rectangle of each in its own frame.

        Raises:
            UnknownNameError: The stance names a sole that the robot does not have.
            KinematicsError: The robot has soles, and none of them carries.
        """
        self.vertices_m = np.zeros((0, 2))
        self._inward, self._offset = np.zeros((0, 2)), np.zeros(0)
        by_frame = {sole.frame: sole for sole in soles}
        corners: list[tuple[float, float]] = []
        for frame, world_T_sole in stance.soles:
            if frame not in by_frame:
                raise UnknownNameError("sole", frame, list(by_frame))
            sole = by_frame[frame]
            for x in sole.x_m:
                for y in sole.y_m:
                    corner = world_T_sole[:3, :3] @ (x, y, 0.0) + world_T_sole[:3, 3]
                    corners.append((float(corner[0]), float(corner[1])))
        if not corners and not soles:
            return
        if not corners:
            raise KinematicsError("a stance without soles has no support polygon")
        self.vertices_m = _convex_hull(corners)
        edges = np.roll(self.vertices_m, -1, axis=0) - self.vertices_m
        lengths = np.linalg.norm(edges, axis=1)
        self._inward = np.column_stack([-edges[:, 1], edges[:, 0]]) / lengths[:, None]
        self._offset = np.sum(self._inward * self.vertices_m, axis=1)

    @property
    def middle_m(self) -> Array:
        """Of the feet, over the floor, shape (2,); of a welded robot, which cannot tip, anywhere."""
        corners_m = self.vertices_m
        return np.zeros(2) if not len(corners_m) else 0.5 * (corners_m.max(axis=0) + corners_m.min(axis=0))

    def com_margin_m(self, com_xy: Array) -> float:
        """Distance of a ground point, shape (2,), to the nearest edge: positive inside.

        Outside it is minus the distance to the line of the edge that is overstepped most, which is
        never more than the distance to the polygon.
        """
        if not len(self._offset):
            return np.inf
        return float((self._inward @ com_xy[:2] - self._offset).min())

    def margins_m(self, points: Array) -> Array:
        """``com_margin_m`` of many ground points, shape (n, 2), at once, shape (n,)."""
        distances = points @ self._inward.T - self._offset
        return np.asarray(np.min(distances, axis=1, initial=np.inf), dtype=np.float64)


def _convex_hull(points: Sequence[tuple[float, float]]) -> Array:
    """Corners of the convex hull, counter-clockwise, by Andrew's monotone chain."""
    ordered = sorted(set(points))

    def half(sequence: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
        chain: list[tuple[float, float]] = []
        for point in sequence:
            while len(chain) >= 2 and _turn(chain[-2], chain[-1], point) <= 1e-12:
                chain.pop()
            chain.append(point)
        return chain[:-1]

    return np.array(half(ordered) + half(ordered[::-1]))


def _turn(a: tuple[float, float], b: tuple[float, float], c: tuple[float, float]) -> float:
    """Twice the signed area of the triangle: positive for a left turn, m^2."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
