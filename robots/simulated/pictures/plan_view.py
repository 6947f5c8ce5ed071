"""A picture of the whole scene from above, with the way that the robot went."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

import mujoco
import numpy as np

from robots.scenes.scene_description import SceneDescription

Point = tuple[float, float]

_BORDER_M = 0.35
_LINE_M = 0.018
_ABOVE_FLOOR_M = 0.02
_COLOR = np.array([0.93, 0.33, 0.10, 1.0])


def plan_camera(
    scene: SceneDescription, path: Sequence[Point], width: int, height: int, fovy_deg: float
) -> mujoco.MjvCamera:
    """A camera that looks straight down on everything that stands about, and on the path.

    Args:
        scene: What stands about.
        path: Where the robot was, in the world.
        width, height: Of the picture, pixels.
        fovy_deg: Its vertical field of view.
    """
    corners = [*path, (scene.robot_start.x_m, scene.robot_start.y_m)]
    for piece in scene.furniture:
        c, s = math.cos(piece.yaw_rad), math.sin(piece.yaw_rad)
        halves = [(x, y) for x in (-0.5, 0.5) for y in (-0.5, 0.5)]
        ends = [(x * piece.size_m[0], y * piece.size_m[1]) for x, y in halves]
        x0, y0 = piece.position_m
        corners += [(x0 + c * x - s * y, y0 + s * x + c * y) for x, y in ends]
    corners += [person.position_m for person in scene.people]
    low, high = np.min(corners, axis=0) - _BORDER_M, np.max(corners, axis=0) + _BORDER_M
    size, middle = high - low, 0.5 * (low + high)
    camera = mujoco.MjvCamera()
    camera.type = mujoco.mjtCamera.mjCAMERA_FREE
    half = math.tan(math.radians(0.5 * fovy_deg))
    camera.lookat = np.array([middle[0], middle[1], 0.9])
    # the longer side of the scene goes along the picture's width
    turned = size[1] > size[0]
    across, along = (size[1], size[0]) if turned else (size[0], size[1])
    camera.distance = 0.5 * max(along, across * height / width) / half
    camera.azimuth = 0.0 if turned else 90.0
    camera.elevation = -90.0
    return camera


def draw_path(picture: mujoco.MjvScene, path: Sequence[Point]) -> None:
    """Add the path to what is drawn: a line a little above the floor."""
    for (ax, ay), (bx, by) in pairwise(path):
        if picture.ngeom >= picture.maxgeom:
            return
        geom = picture.geoms[picture.ngeom]
        mujoco.mjv_initGeom(
            geom,
            mujoco.mjtGeom.mjGEOM_CAPSULE,
            np.zeros(3),
            np.zeros(3),
            np.zeros(9),
            _COLOR.astype(np.float32),
        )
        mujoco.mjv_connector(
            geom,
            mujoco.mjtGeom.mjGEOM_CAPSULE,
            _LINE_M,
            np.array([ax, ay, _ABOVE_FLOOR_M]),
            np.array([bx, by, _ABOVE_FLOOR_M]),
        )
        picture.ngeom += 1
