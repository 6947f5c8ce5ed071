"""How much of each solid a simulated camera has in sight."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Shape
from kinematics.model.camera_description import CameraDescription
from robots.perception.surface import surface_points
from robots.perception.truth_view import TrueObject, TruthView


class Sight:
    """Field of view, range and line of sight of one camera.

    Attributes:
        tan: Tangents of half the horizontal and half the vertical field of view.
    """

    def __init__(self, truth: TruthView, camera: CameraDescription) -> None:
        self._truth = truth
        self._range_m = camera.range_m
        self.tan = math.tan(0.5 * camera.horizontal_fov_rad), math.tan(0.5 * camera.vertical_fov_rad)

    def shares(self, solids: Sequence[TrueObject], world_T_camera: Transform) -> list[float]:
        """Of each solid, the share of its surface towards the camera that is in view and not hidden.

        All points go through the geometry together; only the rays are asked for solid by solid.
        """
        if not solids:
            return []
        points, normals, owner, slices = _stacked(tuple(solid.shape for solid in solids))
        poses_of = np.array([solid.world_T_object for solid in solids])
        rotation = poses_of[owner, :3, :3]
        world = np.einsum("nij,nj->ni", rotation, points) + poses_of[owner, :3, 3]
        outward = np.einsum("nij,nj->ni", rotation, normals)
        from_camera = world - world_T_camera[:3, 3]
        facing = np.einsum("ni,ni->n", outward, from_camera) < 0.0
        candidate = facing & self._in_view(from_camera @ world_T_camera[:3, :3])
        counts = np.bincount(owner, facing, len(solids))
        shares = []
        for solid, part, count in zip(solids, slices, counts, strict=True):
            seen = candidate[part]
            if count == 0.0 or not seen.any():
                shares.append(0.0)
                continue
            visible = self._truth.visible(solid.name, world[part][seen])
            shares.append(float(np.count_nonzero(visible) / count))
        return shares

    def _in_view(self, camera_points: Array) -> NDArray[np.bool_]:
        x, y, z = camera_points.T
        near, far = self._range_m
        inside: NDArray[np.bool_] = (
            (z >= near) & (z <= far) & (np.abs(x) <= self.tan[0] * z) & (np.abs(y) <= self.tan[1] * z)
        )
        return inside


@lru_cache(maxsize=64)
def _stacked(shapes: tuple[Shape, ...]) -> tuple[Array, Array, NDArray[np.intp], tuple[slice, ...]]:
    """Surface points of several solids in one array, with the owner of each and each one's part."""
    sampled = [surface_points(shape) for shape in shapes]
    counts = [len(points) for points, _ in sampled]
    ends = np.cumsum(counts)
    slices = tuple(slice(int(end - count), int(end)) for end, count in zip(ends, counts, strict=True))
    owner = np.repeat(np.arange(len(shapes)), counts)
    return (
        np.concatenate([points for points, _ in sampled]),
        np.concatenate([normals for _, normals in sampled]),
        owner,
        slices,
    )
