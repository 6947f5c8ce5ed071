"""Balls about the solids of a geometry model: what is apart by them is apart."""

from __future__ import annotations

import numpy as np
import pinocchio as pin

from kinematics.arrays import Array


class EnclosingBalls:
    """A ball about each solid, in its own frame.

    Args:
        geometry: Solids whose local boxes were computed, and the pairs that are asked about.

    Attributes:
        enough_m: Distance of the centres of each pair at which the balls just touch, shape (p,).
    """

    def __init__(self, geometry: pin.GeometryModel) -> None:
        solids = [item.geometry for item in geometry.geometryObjects]
        self._centres = np.array([solid.aabb_center for solid in solids])
        self._radii = np.array([solid.aabb_radius for solid in solids])
        pairs = np.array([(pair.first, pair.second) for pair in geometry.collisionPairs], np.intp)
        self._first, self._second = pairs.reshape(-1, 2).T
        self.enough_m = self._radii[self._first] + self._radii[self._second]

    def centres_m(self, placed: pin.GeometryData) -> Array:
        """Where they are, shape (n, 3)."""
        at = np.array([place.homogeneous for place in placed.oMg])
        return np.asarray(np.einsum("nij,nj->ni", at[:, :3, :3], self._centres) + at[:, :3, 3])

    def gaps_m(self, placed: pin.GeometryData) -> Array:
        """Gap between the balls of each pair, negative where they overlap, shape (p,)."""
        centres = self.centres_m(placed)
        apart = np.linalg.norm(centres[self._first] - centres[self._second], axis=1)
        return np.asarray(apart - self.enough_m)
