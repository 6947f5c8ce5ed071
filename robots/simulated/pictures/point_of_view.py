"""From which side a picture shows most of the robot and of the things around it."""

from __future__ import annotations

import math
from collections.abc import Iterator

import mujoco
import numpy as np

from kinematics.arrays import Array
from robots.scenes.articulated import HANDLE
from robots.scenes.scene_description import Furniture
from robots.simulated.body.geom_roles import DRAWN_GROUP, WORLD_GROUP
from robots.simulated.world import SimulatedWorld

SIDES_RAD = tuple(math.radians(angle) for angle in (145.0, -145.0, 105.0, -105.0, 40.0, -40.0))
"""Directions of the camera about the robot's heading: from ahead, from the sides, over its shoulders."""
DISTANCES_M = (2.7, 3.6)
"""From the middle of the picture: nearer first."""
_TOUCHES_M = 0.15
"""A ray that ends this near to its aim has reached it: the aim is inside a solid."""
_IN_PICTURE = 0.9
"""Share of half the picture within which something counts as shown."""


def clearest_view(
    world: SimulatedWorld, lookat: Array, elevation_rad: float, aspect: float
) -> tuple[float, float]:
    """The camera's direction, rad about the robot's heading, and distance, m, that show most.

    Args:
        world: What is to be drawn.
        lookat: The middle of the picture, in the world, shape (3,).
        elevation_rad: Of the camera's axis, negative when it looks down.
        aspect: Width of the picture over its height.
    """
    pose = world.truth.world_T_base()
    heading = math.atan2(pose[1, 0], pose[0, 0])
    world.physics.refresh()
    half_height = math.tan(0.5 * math.radians(float(world.physics.model.vis.global_.fovy)))
    aims = list(_aims(world))

    def shown(view: tuple[float, float]) -> int:
        turn, rise = heading + view[0], elevation_rad
        axis = np.array([math.cos(rise) * math.cos(turn), math.cos(rise) * math.sin(turn), math.sin(rise)])
        right = np.array([math.sin(turn), -math.cos(turn), 0.0])
        up = np.cross(right, axis)
        eye = lookat - view[1] * axis
        return sum(
            _in_picture((aim - eye) @ np.column_stack([right, up, axis]), half_height, aspect)
            and _reaches(world, eye, aim)
            for aim in aims
        )

    views = [(side, distance) for distance in DISTANCES_M for side in SIDES_RAD]
    return max(views, key=shown)  # of equals the first


def _in_picture(place: Array, half_height: float, aspect: float) -> bool:
    """Whether a place (to the right, up, away) is well inside the picture."""
    right, up, away = (float(value) for value in place)
    room = _IN_PICTURE * half_height * away
    return away > 0.0 and abs(up) < room and abs(right) < aspect * room


def _aims(world: SimulatedWorld) -> Iterator[Array]:
    truth = world.truth
    yield truth.world_T_base()[:3, 3]
    yield truth.world_T_camera()[:3, 3]
    for name in truth.objects():
        yield truth.world_T_object(name)[:3, 3]
    for solid in truth.solids():
        if solid.category == "person" or solid.kind == HANDLE:
            yield solid.world_T_object[:3, 3]
    for piece in world.physics.scene.furniture:
        if piece.opens is not None:
            yield _front(piece)


def _front(piece: Furniture) -> Array:
    """The middle of the side that opens: an open door's handle may be hidden by what it was opened for."""
    (x, y), (depth, _, height) = piece.position_m, piece.size_m
    inwards = np.array([math.cos(piece.yaw_rad), math.sin(piece.yaw_rad)])
    return np.array([*(np.array([x, y]) - 0.5 * depth * inwards), 0.5 * height])


def _reaches(world: SimulatedWorld, eye: Array, aim: Array) -> bool:
    groups = np.zeros(mujoco.mjNGROUP, dtype=np.uint8)
    groups[[WORLD_GROUP, DRAWN_GROUP]] = 1
    way = aim - eye
    hit = np.zeros(1, dtype=np.int32)
    physics = world.physics
    share = mujoco.mj_ray(physics.model, physics.data, eye, way, groups, 1, -1, hit)
    return bool(share < 0.0 or (1.0 - share) * float(np.linalg.norm(way)) < _TOUCHES_M)
