"""Where on tops something could stand that no look has shown."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.ik.gaze import in_picture
from kinematics.model.camera_description import CameraDescription
from kinematics.scene.line_of_sight import hidden, near_line
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from trees.beliefs.sight.sight import Glimpse

GRID_M = 0.04
# Heights above the top: something that stands there is seen by its middle.
HEIGHTS_M = (0.03, 0.08)
# From the edge of the top, and from what stands there.
_EDGE_M, _BESIDE_M = 0.03, 0.02
# What something else hides is where things hide; what was never in the picture may just be empty.
HIDDEN_WORTH, UNSEEN_WORTH = 3.0, 1.0


def hidden_places(
    scene: PlanningScene, glimpses: tuple[Glimpse, ...], camera: CameraDescription, clear_m: float
) -> tuple[Array, Array]:
    """Points over tops that no look has shown, shape (n, 3), and the worth of seeing each, shape (n,).

    Args:
        scene: What is believed; it hides things.
        glimpses: The looks.
        camera: What it sees.
        clear_m: A line of sight that passes a part of the robot nearer than this may be blocked.
    """
    tops = [item for item in scene.objects.values() if not item.movable and is_top(item)]
    points = np.concatenate([_over(top, scene) for top in tops] or [np.empty((0, 3))])
    shown = np.zeros(len(points), dtype=bool)
    in_sight = np.zeros(len(points), dtype=bool)
    for glimpse in glimpses:
        pose = glimpse.odom_T_camera
        seen = np.flatnonzero(
            ~shown & in_picture(points, pose, camera.horizontal_fov_rad, camera.vertical_fov_rad)
        )
        in_sight[seen] = True
        blocked = hidden(pose[:3, 3], points[seen], scene.objects.values())
        blocked |= near_line(pose[:3, 3], points[seen], np.array(glimpse.in_the_way), clear_m)
        shown[seen[~blocked]] = True
    left = ~shown
    return points[left], np.where(in_sight[left], HIDDEN_WORTH, UNSEEN_WORTH)


def is_top(item: SceneObject) -> bool:
    """Whether things stand on it: flat, and wider than high."""
    return isinstance(item.shape, Box) and min(item.shape.size_m[:2]) > 2.0 * item.shape.height_m


def _over(top: SceneObject, scene: PlanningScene) -> Array:
    """A grid of points over a top, without those inside what stands there."""
    assert isinstance(top.shape, Box)
    depth, width, height = top.shape.size_m
    axes = [np.arange(-0.5 * size + _EDGE_M, 0.5 * size - _EDGE_M, GRID_M) for size in (depth, width)]
    x, y, z = np.meshgrid(*axes, 0.5 * height + np.array(HEIGHTS_M), indexing="ij")
    local = np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)
    points = local @ top.world_T_object[:3, :3].T + top.world_T_object[:3, 3]
    free = np.ones(len(points), dtype=bool)
    for item in scene.objects.values():
        if item.movable:
            free &= ~_inside(points, item)
    return np.asarray(points[free])


def _inside(points: Array, item: SceneObject) -> NDArray[np.bool_]:
    inverse = poses.inverse(item.world_T_object)
    local = points @ inverse[:3, :3].T + inverse[:3, 3]
    if isinstance(item.shape, Box):
        half = 0.5 * np.array(item.shape.size_m[:2]) + _BESIDE_M
        return np.asarray(np.all(np.abs(local[:, :2]) <= half, axis=1), dtype=np.bool_)
    return np.asarray(np.linalg.norm(local[:, :2], axis=1) <= item.shape.radius_m + _BESIDE_M, dtype=np.bool_)
