"""Depths as points in a level frame, and how uncertain they are."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import InFloat64
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from robots.perception.rgbd.picture import Depths, Mask, Picture


@dataclass(frozen=True, slots=True)
class Cloud(InFloat64):
    """What each pixel shows, in the odometry frame (z up, floor at 0).

    Attributes:
        x, y, z: Coordinates, shape (height, width) each; meaningless where ``there`` is false.
        there: Where something came back that is not the robot itself.
        depth_m: Depths along the optical axis, 0 where nothing came back.
        sigma_m: Standard deviation of a depth.
        odom_T_camera: Where the camera was, shape (4, 4).
        picture: What it was made of.
    """

    x: Depths
    y: Depths
    z: Depths
    there: Mask
    depth_m: Depths
    sigma_m: Depths
    odom_T_camera: Transform
    picture: Picture

    def turned(self, rotation: NDArray[np.float64]) -> Cloud:
        """The same cloud, turned about the camera: what is found level corrects where the camera looked."""
        turned = self.odom_T_camera.copy()
        turned[:3, :3] = rotation @ turned[:3, :3]
        x, y, z = _points(self.picture, turned)
        return replace(self, x=x, y=y, z=z, odom_T_camera=turned)


def cloud_of(picture: Picture) -> Cloud:
    """The points of a picture."""
    errors = picture.camera.errors
    depth = picture.depth_m
    beyond = np.maximum(depth - np.float32(errors.sharp_m), 0.0)
    sigma = np.float32(errors.depth_noise_m) + np.float32(errors.depth_noise_per_m2) * beyond * beyond
    x, y, z = _points(picture, picture.odom_T_camera)
    there = (depth > 0.0) & ~picture.own
    return Cloud(x, y, z, there, depth, sigma, picture.odom_T_camera, picture)


def _points(picture: Picture, odom_T_camera: Transform) -> tuple[Depths, Depths, Depths]:
    across, down = picture.rays()
    made = []
    for row in odom_T_camera[:3].astype(np.float32):
        ray = (row[0] * across + row[2])[None, :] + (row[1] * down)[:, None]
        ray *= picture.depth_m
        ray += row[3]
        made.append(ray)
    return made[0], made[1], made[2]


def rays_through(picture: Picture, odom_T_camera: Transform, u: Depths, v: Depths) -> NDArray[np.float64]:
    """Directions of pixels in the odometry frame, of unit depth along the axis, shape (n, 3)."""
    height, width = picture.depth_m.shape
    focal = picture.camera.focal_px
    rays = np.column_stack(
        [(u - 0.5 * (width - 1)) / focal, (v - 0.5 * (height - 1)) / focal, np.ones(len(u))]
    )
    return np.asarray(rays @ odom_T_camera[:3, :3].T, dtype=np.float64)


def levelling(slope_x: float, slope_y: float) -> NDArray[np.float64]:
    """The rotation that makes a plane z = slope_x x + slope_y y + c level."""
    normal = np.array([-slope_x, -slope_y, 1.0])
    normal /= np.linalg.norm(normal)
    axis = np.cross(normal, (0.0, 0.0, 1.0))
    return poses.rotation_from_vector(axis)


def depth_jumps(depth: Depths, sigma: Depths, least_m: float, sigmas: float) -> Mask:
    """The farther one of each two neighbouring pixels between which depth jumps.

    Args:
        depth: In m, 0 where nothing came back.
        sigma: Standard deviation of each depth, m.
        least_m: A smaller step is no jump.
        sigmas: Nor is one of fewer standard deviations.
    """
    least = np.maximum(np.float32(least_m), np.float32(sigmas) * sigma)
    jumps = np.zeros(depth.shape, np.bool_)
    for axis in (0, 1):
        step = np.diff(depth, axis=axis)
        near = (slice(None, -1), slice(None)) if axis == 0 else (slice(None), slice(None, -1))
        far = (slice(1, None), slice(None)) if axis == 0 else (slice(None), slice(1, None))
        both = (depth[far] > 0.0) & (depth[near] > 0.0)
        jumps[far] |= both & (step > least[far])
        jumps[near] |= both & (-step > least[near])
    return jumps
