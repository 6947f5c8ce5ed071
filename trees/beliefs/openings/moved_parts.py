"""Doors and drawers move: what a look has seen anew does not stand in the scene twice."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

import numpy as np
from numpy.typing import NDArray

from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box, Shape
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.perception.object_estimate import ObjectEstimate
from robots.scenes.articulated import DOOR, PART_KINDS
from trees.beliefs.openings.handles import BODY_OF, INSIDE_KINDS
from trees.beliefs.scene.scene_update import kind_of

_WITHIN_M = 1.0
"""So far at most a part moves."""
_SAME_EDGE_M = 0.2
_SAME_LINE_M = 0.25
"""What is believed of the odometry is off by less, and the next front is farther away."""
_SAME_YAW_RAD = 0.1
_MOVED_M = 0.04
"""Two looks at one front that stays are nearer to each other."""
_AT_ONE_PLACE_M = 0.15


def without_moved_parts(scene: PlanningScene, estimates: Iterable[ObjectEstimate]) -> PlanningScene:
    """A scene without the doors, drawers, handles and insides that a look has seen anew.

    What belongs to another front stays: that of the fridge beside it. What a model tells is known again,
    wherever it is; of that goes what its front has taken along, out of sight.
    """
    moving = (*PART_KINDS, *INSIDE_KINDS)
    fresh = [item for item in estimates if item.kind in moving]
    every = {name: item for name, item in scene.objects.items() if kind_of(name) in moving}
    for name, item in every.items():
        if _went_along(item, every.values(), fresh):
            scene = scene.without_object(name)
    known = {name: item for name, item in every.items() if item.moves is None}
    fresh = [item for item in fresh if item.moves is None]
    fronts = {name: item for name, item in known.items() if kind_of(name) in BODY_OF}
    gone = {
        name
        for name, item in fronts.items()
        if any(
            one.kind == kind_of(name)
            and _is_same(one.kind, item.world_T_object, item.shape, one.odom_T_object, one.shape)
            for one in fresh
        )
    }
    for name, item in known.items():
        if name in fronts:
            continue
        away_m = [
            float(np.linalg.norm(one.odom_T_object[:3, 3] - item.world_T_object[:3, 3]))
            for one in fresh
            if one.kind == kind_of(name)
        ]
        nearest_m = min(away_m, default=math.inf)
        owner = _nearest(item.world_T_object, {front: known[front].world_T_object for front in fronts})
        if nearest_m <= _AT_ONE_PLACE_M or (nearest_m <= _WITHIN_M and (owner is None or owner in gone)):
            gone.add(name)
    for name in gone:
        scene = scene.without_object(name)
    return scene


def _went_along(item: SceneObject, known: Iterable[SceneObject], fresh: Iterable[ObjectEstimate]) -> bool:
    """Whether what was known of a door or drawer is not seen now, and its front is, elsewhere."""
    moves, kind, fresh = item.moves, kind_of(item.name), list(fresh)
    if moves is None or any(
        one.kind == kind and one.moves is not None and one.moves.is_same(moves) for one in fresh
    ):
        return False
    return any(
        one.moves is not None
        and front.moves is not None
        and one.kind == kind_of(front.name)
        and one.moves.is_same(front.moves)
        and front.moves.is_of(moves)
        and math.dist(front.world_T_object[:3, 3], one.odom_T_object[:3, 3]) > _MOVED_M
        for front in known
        for one in fresh
    )


def _nearest(pose: Transform, fronts: dict[str, Transform]) -> str | None:
    away = {name: float(np.linalg.norm(front[:3, 3] - pose[:3, 3])) for name, front in fronts.items()}
    return min(away, key=lambda name: (away[name], name), default=None)


def _is_same(kind: str, a: Transform, a_shape: Shape, b: Transform, b_shape: Shape) -> bool:
    """Whether two poses may be those of one front, more and less open."""
    apart = b[:3, 3] - a[:3, 3]
    if float(np.linalg.norm(apart)) > _WITHIN_M:
        return False
    if kind != DOOR:  # along its line
        return math.hypot(float(apart @ a[:3, 1]), float(apart[2])) <= _SAME_LINE_M
    turned = poses.yaw_of(a[:3, :3]) - poses.yaw_of(b[:3, :3])
    if abs(math.sin(turned)) < math.sin(_SAME_YAW_RAD):
        return float(np.linalg.norm(apart)) <= _SAME_LINE_M
    return any(
        float(np.linalg.norm(first - second)) <= _SAME_EDGE_M
        for first in _edges(a, a_shape)
        for second in _edges(b, b_shape)
    )


def _edges(pose: Transform, shape: Shape) -> Iterator[NDArray[np.float64]]:
    """Where the upright edges of a panel stand, each of shape (2,)."""
    half_m = 0.5 * shape.size_m[1] if isinstance(shape, Box) else 0.0
    yield pose[:2, 3] + half_m * pose[:2, 1]
    yield pose[:2, 3] - half_m * pose[:2, 1]
