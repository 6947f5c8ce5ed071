"""Who stands nearest to something that somebody may take hold of."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from kinematics.scene import PlanningScene
from trees.believed_thing import PERSON
from trees.scene_update import kind_of

_CLEARLY_M = 0.05
"""Who is nearer by less than this may be the one who is farther away."""


def nearer_than(addressed: str, point_m: NDArray[np.float64], scene: PlanningScene) -> str | None:
    """Name of somebody who is clearly nearer to a point than whom it is meant for; None when nobody is.

    Args:
        addressed: Whom it is meant for, by the name in the planning scene.
        point_m: In the odometry frame, shape (3,) or (2,).
        scene: What is believed.
    """
    away_m = {
        name: math.dist(point_m[:2].tolist(), item.world_T_object[:2, 3].tolist())
        for name, item in scene.objects.items()
        if kind_of(name) == PERSON or name[:1].isupper()
    }
    nearest = min(away_m, key=lambda name: (away_m[name], name), default=addressed)
    if addressed not in away_m or away_m[nearest] > away_m[addressed] - _CLEARLY_M:
        return None
    return nearest
