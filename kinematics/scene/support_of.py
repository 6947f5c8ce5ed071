"""What an object stands on, as far as a scene knows."""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from kinematics.scene.free_spots import footprint_radius_m
from kinematics.scene.planning_scene import PlanningScene, SceneObject

# An object that is lifted may touch what its foot is this near to, above or below.
TOUCHING_M = 0.03
# Its middle may be this far beyond the edge of what carries it.
BESIDE_M = 0.02
# How large a place is where it is asked what is below it, and what plans keep beyond margins, at most.
_SPOT_M = (0.02, 0.02, 0.002)
_KEPT_BEYOND_M = 0.005


def lowest_point_m(item: SceneObject) -> float:
    """Height of an object's lowest point."""
    return float(item.world_T_object[2, 3]) - half_height_m(item)


def top_m(item: SceneObject) -> float:
    """Height of an object's highest point."""
    return float(item.world_T_object[2, 3]) + half_height_m(item)


def half_height_m(item: SceneObject) -> float:
    """Half the vertical extent of an object as it stands or lies."""
    shape, up = item.shape, item.world_T_object[2, :3]
    if isinstance(shape, Ball):
        return shape.radius_m
    if isinstance(shape, Box):
        return 0.5 * float(np.abs(up) @ np.array(shape.size_m))
    if isinstance(shape, Cylinder):
        lean = float(np.sqrt(max(0.0, 1.0 - up[2] ** 2)))
        return 0.5 * shape.height_m * abs(float(up[2])) + shape.radius_m * lean
    raise TypeError(f"no shape {type(shape).__name__}")


def supports_of(
    item: SceneObject, scene: PlanningScene, gap_m: float = TOUCHING_M, beside_m: float = BESIDE_M
) -> list[str]:
    """Names of what is right under an object: furniture first, then things that it may be stacked on.

    Args:
        item: The object.
        scene: What is around.
        gap_m: Between its lowest point and the top of what carries it, at most.
        beside_m: Its middle may be so far beyond the edge of furniture; it is over a thing, or beside that.
    """
    bottom = lowest_point_m(item)
    names: dict[bool, list[str]] = {False: [], True: []}
    for other in scene.objects.values():
        if other.name == item.name or abs(bottom - top_m(other)) > gap_m:
            continue
        if _is_over(item, other, 0.0 if other.movable else beside_m):
            names[other.movable].append(other.name)
    return names[False] + names[True]


def under_foot_of(item: SceneObject, scene: PlanningScene) -> list[str]:
    """Names of what is under any part of an object's foot: a chest's top, and the wall that carries it.

    Args:
        item: The object.
        scene: What is around.
    """
    return supports_of(item, scene, beside_m=BESIDE_M + footprint_radius_m(item.shape))


def furniture_right_below(place_m: Array, scene: PlanningScene) -> list[str]:
    """Names of the furniture that a place is nearer to than what is kept from that.

    What stands there may come so near to it: a burner is a part of a stove's top, and a plate is thin.

    Args:
        place_m: On top of something, m, shape (3,).
        scene: What is around.
    """
    fixed = [item for item in scene.objects.values() if not item.movable]
    gap_m = max((item.margin_m for item in fixed), default=0.0) + _KEPT_BEYOND_M
    x, y, z = place_m.tolist()
    spot = SceneObject("", Box(_SPOT_M), poses.translation(x, y, z + 0.5 * _SPOT_M[2]))
    return supports_of(spot, PlanningScene().with_objects(fixed), gap_m)


def support_of(item: SceneObject, scene: PlanningScene, gap_m: float) -> SceneObject | None:
    """The piece of furniture that an object stands on, be it on other things, all ``gap_m`` wrong at most."""
    below, passed = item, {item.name}
    while True:
        names = [name for name in supports_of(below, scene, gap_m, gap_m) if name not in passed]
        if not names:
            return None
        below = scene.objects[names[0]]
        if not below.movable:
            return below
        passed.add(below.name)


def _is_over(item: SceneObject, other: SceneObject, beside_m: float) -> bool:
    """Whether the middle of an object is over the top of another."""
    pose = other.world_T_object
    x, y, _ = pose[:3, :3].T @ (item.world_T_object[:3, 3] - pose[:3, 3])
    if isinstance(other.shape, Box):
        half = 0.5 * np.array(other.shape.size_m[:2])
        return bool(np.all(np.abs((x, y)) <= half + beside_m))
    return bool(np.hypot(x, y) <= other.shape.radius_m + beside_m)
