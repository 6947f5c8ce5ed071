"""Which solids are boards and sides of the same piece of furniture."""

from __future__ import annotations

import math

from kinematics.arrays import Array
from kinematics.scene.planning_scene import SceneObject
from trees.beliefs.scene.scene_update import kind_of

_WITHIN_M = 1.0


def are_one_piece(first: SceneObject, second: SceneObject) -> bool:
    """Solids of one kind near each other: they have the same word, and numbers apart."""
    return belong_together(first.name, first.world_T_object[:3, 3], second.name, second.world_T_object[:3, 3])


def belong_together(name: str, place_m: Array, other: str, there_m: Array) -> bool:
    """The same of names and places, shape (3,), in any one frame."""
    (x, y, _), (there_x, there_y, _) = place_m.tolist(), there_m.tolist()
    return kind_of(name) == kind_of(other) and math.hypot(x - there_x, y - there_y) <= _WITHIN_M
