"""What is shut shows nothing of what is inside."""

from __future__ import annotations

import math

from kinematics.scene.planning_scene import PlanningScene
from robots.scenes.articulated import DOOR, DRAWER
from trees.beliefs.openings.drawer_inside import inside_of_drawer
from trees.beliefs.openings.fridge_inside import door_opening_rad
from trees.beliefs.openings.handles import MEANT_BY
from trees.failures import Failure, FailureKind

_AJAR_RAD = math.radians(10.0)
"""A door that is less open shows nothing."""


def why_shut(scene: PlanningScene, word: str) -> Failure | None:
    """Why nothing can be told of the inside of what is called so; None where it is open, or has no inside.

    Args:
        scene: What is believed.
        word: "fridge", "drawer"; anything else is no matter.
    """
    told = Failure.infeasible(f"the {word} is shut: open it first ('open the {word}')")
    if MEANT_BY.get(word) == DOOR:
        opening = door_opening_rad(scene)
        return told if opening is not None and opening < _AJAR_RAD else None
    if MEANT_BY.get(word) == DRAWER:
        inside = inside_of_drawer(scene)
        return told if isinstance(inside, Failure) and inside.kind is FailureKind.INFEASIBLE else None
    return None
