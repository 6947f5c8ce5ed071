"""On top of another thing: whether its top carries, and where on it there is room."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry.shapes import Ball, Box, Shape
from kinematics.scene.free_spots import FreeSpot, footprint_radius_m, spots_on
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.scene.support_of import lowest_point_m, top_m
from trees.beliefs.grounding.articles import with_article
from trees.beliefs.grounding.destination import furniture_named
from trees.beliefs.grounding.grounding import Ambiguous, Found, ground
from trees.beliefs.grounding.questions import which_is_meant
from trees.beliefs.scene.believed_thing import Surroundings
from trees.beliefs.scene.scene_update import kind_of
from trees.failures import Failure
from trees.tasks import Destination, ObjectDescription

CARRIES_M = 0.018
"""Half of a top's width, at least: what is put on its middle may stand 1 cm beside it, and must not tip."""
_LEVEL_M = 0.004
"""What ends so little below the highest point of a thing is its top as well."""
_LEANS_COSINE = math.cos(math.radians(12.0))
_ON_IT_M = 0.03
_ANGLES_RAD = np.linspace(0.0, 2.0 * math.pi, 72, endpoint=False)
_WAYS = np.array([np.cos(_ANGLES_RAD), np.sin(_ANGLES_RAD)])
"""Unit vectors all around, shape (2, 72)."""


def thing_called(
    named: Destination | None, scene: PlanningScene, around: Surroundings
) -> SceneObject | Failure | None:
    """The thing that somebody wants something put on; None where furniture is meant, or nothing is called so.

    Args:
        named: What something is put on.
        scene: What is believed to be around.
        around: The same from where the robot stands, without what is going to be moved.
    """
    wanted = ObjectDescription(named) if isinstance(named, str) else named
    if not isinstance(wanted, ObjectDescription) or not (wanted.kind or wanted.name):
        return None
    if wanted.kind is not None and wanted.color is None and furniture_named(wanted.kind, scene):
        return None
    match ground(wanted, around):
        case Found(names) if scene.objects[names[0]].movable:
            return scene.objects[names[0]]
        case Ambiguous(_, choices) as unclear if all(scene.objects[one.name].movable for one in choices):
            return which_is_meant(unclear, "on")
        case _:
            return None


def why_not_on(thing: SceneObject, held: Shape | None) -> Failure | None:
    """Why a thing carries nothing, or not this; None when it does.

    Args:
        thing: What is to carry.
        held: What is to be put on it; None while nobody knows.
    """
    name = kind_of(thing.name)
    if isinstance(thing.shape, Ball):
        return Failure.infeasible(f"nothing stands on {with_article(name)}: it is round")
    if thing.world_T_object[2, 2] < _LEANS_COSINE:
        return Failure.infeasible(f"nothing can be put on the {name}: it does not stand upright")
    flat_m, rim_m = _carried(thing.shape)
    if flat_m >= CARRIES_M:
        return None
    if rim_m < CARRIES_M:
        return Failure.infeasible(f"the top of the {name} is too small, or not flat, to put something on it")
    if held is not None and _foot_m(held) < rim_m:
        message = f"the {name} is open at the top, and what is put on it falls in: say to put it into that"
        return Failure.infeasible(message)
    return None


def spots_on_thing(
    thing: SceneObject,
    held: Shape,
    scene: PlanningScene,
    wish: Callable[[Array], float],
    shown: Callable[[Array], bool],
) -> list[FreeSpot] | Failure:
    """Where on a thing another one can stand: in its middle, or where a large one has room besides.

    Args:
        thing: What is to carry.
        held: The solid that is put on it.
        scene: Everything that may stand there.
        wish: Cost of a place, shape (3,).
        shown: Whether a look has shown what is at a place, shape (3,).
    """
    if (failure := why_not_on(thing, held)) is not None:
        return failure
    on_it = [item for item in scene.objects.values() if _stands_on(item, thing)]
    middle = np.append(thing.world_T_object[:2, 3], top_m(thing))
    spots = [FreeSpot(middle, 0.0)] if not on_it and shown(middle) else []
    if isinstance(thing.shape, Box) and thing.shape.parts is None:
        spots += spots_on(thing, scene, footprint_radius_m(held), wish, shown)
    if not spots and on_it:
        return Failure.infeasible(f"the {kind_of(on_it[0].name)} is on the {kind_of(thing.name)} already")
    return spots


def _stands_on(item: SceneObject, thing: SceneObject) -> bool:
    """Whether an object is on another one, anywhere over its top."""
    if not item.movable or item.name == thing.name:
        return False
    away_m = float(np.linalg.norm(item.world_T_object[:2, 3] - thing.world_T_object[:2, 3]))
    reach_m = 0.5 * (footprint_radius_m(item.shape) + footprint_radius_m(thing.shape))
    return abs(lowest_point_m(item) - top_m(thing)) <= _ON_IT_M and away_m < reach_m


def _carried(shape: Shape) -> tuple[float, float]:
    """Radius of the largest circle, about its middle, on the top itself; and of that around which it goes."""
    parts = shape.parts
    if parts is None:
        half_m = 0.5 * min(shape.size_m[:2]) if isinstance(shape, Box) else shape.radius_m
        return half_m, half_m
    level_m = float(parts.corners[:, 2].max()) - _LEVEL_M
    tops = [hull[hull[:, 2] >= level_m][:, :2] for hull in parts.hulls]
    flat_m = max(float((top @ _WAYS).max(axis=0).min()) for top in tops if len(top))
    return max(flat_m, 0.0), float(np.linalg.norm(np.concatenate(tops), axis=1).max())


def _foot_m(shape: Shape) -> float:
    """Half the least width of a solid's foot."""
    return 0.5 * min(shape.size_m[:2]) if isinstance(shape, Box) else shape.radius_m
