"""Who has taken something: the one towards whom it went."""

from __future__ import annotations

import math

from kinematics.geometry.poses import Transform
from kinematics.scene.planning_scene import PlanningScene
from trees.beliefs.scene.believed_thing import PERSON
from trees.beliefs.scene.scene_update import kind_of

_CLEARLY_M = 0.05
"""Who is in nearly the same direction may be the one whom it was meant for."""


def another_took_it(addressed: str, let_go: Transform, now: Transform, scene: PlanningScene) -> str | None:
    """Name of somebody towards whom a thing went, if not towards whom it was meant for.

    Args:
        addressed: Whom it was meant for, by the name in the planning scene.
        let_go, now: Where the thing was let go and where it was seen since, odometry frame, shape (4, 4).
        scene: What is believed.
    """
    nearer_m = {
        name: _apart_m(let_go, item.world_T_object) - _apart_m(now, item.world_T_object)
        for name, item in scene.objects.items()
        if kind_of(name) == PERSON or name[:1].isupper()
    }
    taker = max(nearer_m, key=lambda name: (nearer_m[name], name), default=addressed)
    if addressed not in nearer_m or nearer_m[taker] < nearer_m[addressed] + _CLEARLY_M:
        return None
    return taker


def _apart_m(one: Transform, other: Transform) -> float:
    """Along the floor."""
    return math.dist(one[:2, 3].tolist(), other[:2, 3].tolist())
