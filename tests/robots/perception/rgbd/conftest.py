"""Pictures of simple solids on a table, traced ray by ray: no simulator, no OpenGL, exact to rounding."""

from dataclasses import dataclass

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from robots.interface.depth_camera import CameraErrors, DepthCamera
from robots.perception.rgbd.picture import Picture


@dataclass(frozen=True)
class Beaker(Cylinder):
    """A cylinder that is open at the top."""

    wall_m: float = 0.003


TABLE_M = 0.8
EDGE_M = (0.3, 1.1)
WOOD = (158, 120, 82)
EXACT = CameraErrors(depth_noise_m=0.0005, depth_noise_per_m2=0.0, depth_step_m=0.0)
CAMERA = DepthCamera("test", "optical", 260.0, 320, 240, errors=EXACT)


def odom_T_camera(height_m=1.5, ahead_m=0.1, tilt_rad=0.8):
    """A camera that looks ahead and down."""
    c, s = np.cos(tilt_rad), np.sin(tilt_rad)
    rotation = np.array([[0.0, -s, c], [-1.0, 0.0, 0.0], [0.0, -c, -s]])
    return poses.transform(rotation, (ahead_m, 0.0, height_m))


def traced(things, camera=CAMERA, place=None, table=WOOD, tint=(1.0, 1.0, 1.0), told=None):
    """The picture of things on a table; each is a shape, its middle's x and y, a heading and a colour,
    and how high it hangs above the table, 0 when left out.

    The camera is at ``place`` and believed to be at ``told``, the same when left out.
    """
    place = odom_T_camera() if place is None else place
    columns = (np.arange(camera.width_px) - 0.5 * (camera.width_px - 1)) / camera.focal_px
    rows = (np.arange(camera.height_px) - 0.5 * (camera.height_px - 1)) / camera.focal_px
    u, v = np.meshgrid(columns, rows)
    rays = np.stack([u, v, np.ones_like(u)], axis=-1) @ place[:3, :3].T
    eye = place[:3, 3]
    depth, color = np.full(u.shape, np.inf), np.zeros((*u.shape, 3))

    def paint(t, hit, rgb):
        nearer = hit & (t > 0.05) & (t < depth)
        depth[nearer] = t[nearer]
        color[nearer] = rgb

    with np.errstate(divide="ignore", invalid="ignore"):
        t = -eye[2] / rays[..., 2]
        paint(t, np.isfinite(t), (110, 115, 120))
        t = (TABLE_M - eye[2]) / rays[..., 2]
        x, y = eye[0] + t * rays[..., 0], eye[1] + t * rays[..., 1]
        paint(t, (x > EDGE_M[0]) & (x < EDGE_M[1]) & (np.abs(y) < 0.6), table)
        for shape, x, y, yaw, rgb, *lift in things:
            t, hit = _hit(shape, x, y, yaw, eye, rays, *lift)
            paint(t, hit, rgb)
    depth[~np.isfinite(depth)] = 0.0
    own = np.zeros(depth.shape, np.bool_)
    seen = np.clip(color * np.array(tint), 0, 255).astype(np.uint8)
    believed = place if told is None else told
    return Picture(camera, seen, depth.astype(np.float32), own, believed, 0.0)


def _hit(shape, x, y, yaw, eye, rays, lift=0.0):
    base = poses.transform(poses.rotation_z(yaw), (x, y, TABLE_M + lift))
    o = base[:3, :3].T @ (eye - base[:3, 3])
    d = rays @ base[:3, :3]
    if isinstance(shape, Ball):
        o = o - np.array([0.0, 0.0, shape.radius_m])
        a, b, c = (d * d).sum(-1), (d * o).sum(-1), o @ o - shape.radius_m**2
        root = b * b - a * c
        return (-b - np.sqrt(np.maximum(root, 0.0))) / a, root > 0.0
    if isinstance(shape, Box):
        half = np.array([*np.array(shape.size_m[:2]) / 2, shape.height_m / 2])
        centre = np.array([0.0, 0.0, half[2]])
        near, far = (-half + centre - o) / d, (half + centre - o) / d
        enter, leave = np.minimum(near, far).max(-1), np.maximum(near, far).min(-1)
        return enter, enter < leave
    a = (d[..., :2] ** 2).sum(-1)
    b, c = (d[..., :2] * o[:2]).sum(-1), o[:2] @ o[:2] - shape.radius_m**2
    root = b * b - a * c
    enter, leave = (-b - np.sqrt(np.maximum(root, 0.0))) / a, (-b + np.sqrt(np.maximum(root, 0.0))) / a
    low, high = -o[2] / d[..., 2], (shape.height_m - o[2]) / d[..., 2]
    enter = np.maximum(enter, np.minimum(low, high))
    leave = np.minimum(leave, np.maximum(low, high))
    hit = (root > 0.0) & (enter < leave)
    if not isinstance(shape, Beaker):
        return enter, hit
    # what comes in through the opening goes on to the far side of the wall, or to the bottom
    c = o[:2] @ o[:2] - (shape.radius_m - shape.wall_m) ** 2
    inner = b * b - a * c
    over = np.minimum(low, high)
    opening = (inner > 0.0) & (over > (-b - np.sqrt(np.maximum(inner, 0.0))) / a)
    beyond = np.minimum((-b + np.sqrt(np.maximum(inner, 0.0))) / a, np.maximum(low, high))
    return np.where(opening & (over < beyond), beyond, enter), hit


@pytest.fixture
def beaker():
    """Makes a cylinder that is open at the top, of a radius and a height."""
    return Beaker


@pytest.fixture
def take():
    """Takes a picture: see ``traced``."""
    return traced


CAN, BOX, BALL = Cylinder(0.035, 0.12), Box((0.06, 0.09, 0.10)), Ball(0.04)
