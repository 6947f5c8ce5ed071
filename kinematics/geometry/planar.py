"""Poses on the floor."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from kinematics.geometry import poses
from kinematics.geometry.poses import Transform


@dataclass(frozen=True, slots=True)
class PlanarPose:
    """Place and heading on the floor: ``a_T_b`` of two frames with parallel z axes.

    Attributes:
        x_m, y_m: Position.
        yaw_rad: Heading; any number of turns.
    """

    x_m: float = 0.0
    y_m: float = 0.0
    yaw_rad: float = 0.0

    def __matmul__(self, other: PlanarPose) -> PlanarPose:
        c, s = math.cos(self.yaw_rad), math.sin(self.yaw_rad)
        return PlanarPose(
            self.x_m + c * other.x_m - s * other.y_m,
            self.y_m + s * other.x_m + c * other.y_m,
            self.yaw_rad + other.yaw_rad,
        )

    def inverse(self) -> PlanarPose:
        """``b_T_a``."""
        c, s = math.cos(self.yaw_rad), math.sin(self.yaw_rad)
        return PlanarPose(
            -c * self.x_m - s * self.y_m,
            s * self.x_m - c * self.y_m,
            -self.yaw_rad,
        )

    def to(self, other: PlanarPose) -> PlanarPose:
        """``other`` as seen from here, its heading within half a turn."""
        seen = self.inverse() @ other
        return PlanarPose(seen.x_m, seen.y_m, wrapped(seen.yaw_rad))

    def sees(self, x_m: float, y_m: float) -> tuple[float, float]:
        """A place as seen from here: ahead and to the left; the same as ``to`` tells of it, sooner."""
        c, s = math.cos(self.yaw_rad), math.sin(self.yaw_rad)
        ahead_m = -c * self.x_m - s * self.y_m + c * x_m + s * y_m
        return ahead_m, s * self.x_m - c * self.y_m - s * x_m + c * y_m

    def distance_m(self, other: PlanarPose) -> float:
        """Between the two positions."""
        return math.hypot(self.x_m - other.x_m, self.y_m - other.y_m)

    def transform(self, z_m: float = 0.0) -> Transform:
        """The same in space, shape (4, 4)."""
        return poses.transform(poses.rotation_z(self.yaw_rad), (self.x_m, self.y_m, z_m))

    @classmethod
    def of(cls, a_T_b: Transform) -> PlanarPose:
        """Shadow on the floor of a pose in space."""
        return cls(float(a_T_b[0, 3]), float(a_T_b[1, 3]), poses.yaw_of(np.asarray(a_T_b)[:3, :3]))

    @classmethod
    def between(cls, first: PlanarPose, second: PlanarPose) -> PlanarPose:
        """Half-way, turning the short way."""
        return cls(
            0.5 * (first.x_m + second.x_m),
            0.5 * (first.y_m + second.y_m),
            first.yaw_rad + 0.5 * wrapped(second.yaw_rad - first.yaw_rad),
        )


def wrapped(angle_rad: float) -> float:
    """The same angle in [-pi, pi)."""
    return (angle_rad + math.pi) % (2.0 * math.pi) - math.pi
