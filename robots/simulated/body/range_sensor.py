"""Ranges by casting rays into the simulated world: what laser scanners at several heights would see."""

from __future__ import annotations

import math

import mujoco
import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from robots.simulated.body.geom_roles import WORLD_GROUP
from robots.simulated.body.physics import Physics

_HEIGHTS_M = (0.10, 0.35, 0.60, 0.80, 0.95, 1.15, 1.40)
_RAYS = 180
_RANGE_M = 4.0
_NOISE_M = 0.01


class SimulatedRangeSensor:
    """Rays to all sides; the robot itself is not seen. Satisfies ``RangeSensor``."""

    def __init__(self, physics: Physics, rng: np.random.Generator) -> None:
        self._physics, self._rng = physics, rng
        angles = np.arange(_RAYS) * (2.0 * math.pi / _RAYS)
        self._directions = np.column_stack([np.cos(angles), np.sin(angles), np.zeros(_RAYS)])
        self._groups = np.zeros(6, dtype=np.uint8)
        self._groups[WORLD_GROUP] = 1

    def scan(self) -> Array:
        """Points on what is around, in a level frame at the base, shape (n, 3)."""
        physics = self._physics
        physics.refresh()
        base = physics.body_pose(physics.base_body)
        turned = np.ascontiguousarray(
            self._directions @ poses.rotation_z(poses.yaw_of(base[:3, :3])).T
        ).ravel()
        found = []
        for height_m in _HEIGHTS_M:
            start = np.array((base[0, 3], base[1, 3], height_m))
            hit = np.full(_RAYS, -1, dtype=np.int32)
            range_m = np.zeros(_RAYS)
            mujoco.mj_multiRay(
                physics.model, physics.data, start, turned, self._groups, True, -1, hit, range_m, None,
                _RAYS, _RANGE_M,
            )  # fmt: skip
            noisy = range_m + self._rng.normal(0.0, _NOISE_M, _RAYS)
            seen = (hit >= 0) & (range_m >= 0.0)
            points = self._directions[seen] * noisy[seen, None]
            points[:, 2] = height_m
            found.append(points)
        return np.vstack(found)
