"""What of a picture shows furniture that is known, and so is neither a thing nor somebody."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from kinematics.geometry.shapes import Box
from robots.perception.rgbd.cloud import Cloud
from robots.perception.rgbd.openings.cabinet import local_in, surface_m
from robots.perception.rgbd.openings.find import SeenCabinet
from robots.perception.rgbd.picture import Mask
from robots.perception.rgbd.piece import Piece

_ON_SIGHT_M, _ON_MAP_M = 0.03, 0.20
"""What is so near to furniture is of it: to what was seen, and to what is only known from the map."""
_EVERY = 4
"""For people it is told for so many rows and columns together."""


class Explained:
    """Furniture that explains points.

    Args:
        cabinets: What opens, as it is seen.
        solids: Of other furniture of the map.
    """

    def __init__(self, cabinets: Sequence[SeenCabinet], solids: Sequence[Piece]) -> None:
        self._cabinets = tuple(cabinets)
        self._solids = [(piece, piece.shape) for piece in solids if isinstance(piece.shape, Box)]

    def left_of(self, cloud: Cloud, mask: Mask) -> Mask:
        """Of some pixels those that show nothing of it."""
        if not (self._cabinets or self._solids) or not mask.any():
            return mask
        rows, columns = np.nonzero(mask)
        found = (cloud.x[rows, columns], cloud.y[rows, columns], cloud.z[rows, columns])
        points = np.column_stack(found).astype(np.float64)
        sigma = cloud.sigma_m[rows, columns].astype(np.float64)
        kept = np.ones(len(points), np.bool_)
        for cabinet in self._cabinets:
            kept &= ~cabinet.explains(points, sigma)
        for piece, box in self._solids:
            half = 0.5 * np.array(box.size_m)
            away = surface_m(local_in(points, piece.odom_T_solid), np.zeros((1, 3)), half[None])
            kept &= away > (_ON_MAP_M if "place" in piece.assumed else _ON_SIGHT_M)
        left = mask.copy()
        left[rows, columns] = kept
        return left

    def without(self, cloud: Cloud) -> Cloud:
        """The cloud without it: a fridge, or a shelf at a wall, is as tall and as wide as somebody."""
        if not (self._cabinets or self._solids):
            return cloud
        thin = np.zeros(cloud.there.shape, np.bool_)
        thin[::_EVERY, ::_EVERY] = cloud.there[::_EVERY, ::_EVERY]
        shown = (thin & ~self.left_of(cloud, thin))[::_EVERY, ::_EVERY]
        wide = shown.repeat(_EVERY, axis=0).repeat(_EVERY, axis=1)
        return replace(cloud, there=cloud.there & ~wide[: cloud.there.shape[0], : cloud.there.shape[1]])
