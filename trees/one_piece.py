"""Which solids are boards and sides of the same piece of furniture."""

from __future__ import annotations

import math

from kinematics.scene import SceneObject
from trees.scene_update import kind_of

_WITHIN_M = 1.0


def are_one_piece(first: SceneObject, second: SceneObject) -> bool:
    """Solids of one kind near each other: they have the same word, and numbers apart."""
    (x, y), (there_x, there_y) = first.world_T_object[:2, 3], second.world_T_object[:2, 3]
    return kind_of(first.name) == kind_of(second.name) and math.hypot(x - there_x, y - there_y) <= _WITHIN_M
