"""What stands about while something else is handled, and whether it still does."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from kinematics.arrays import Array
from kinematics.scene.planning_scene import PlanningScene
from trees.failures import Failure


def bystanders(scene: PlanningScene) -> dict[str, Array]:
    """Places of all movable things of a scene by name, shape (3,) each."""
    return {item.name: item.world_T_object[:3, 3] for item in scene.objects.values() if item.movable}


def disturbed(
    stood: Mapping[str, Array], scene: PlanningScene, tolerance_m: float, except_for: str | None = None
) -> Failure | None:
    """The first bystander that is not where it stood, or None.

    One that could not be seen is still believed where it was; one that should have been seen and was not
    is gone from the scene.

    Args:
        stood: Where they were before.
        scene: What is believed after a new look.
        tolerance_m: Farther than this is moved.
        except_for: Name of one that is judged elsewhere.
    """
    for name, place in sorted(stood.items()):
        if name == except_for:
            continue
        now = scene.objects.get(name)
        if now is None:
            return Failure.postcondition(f"the {name} is no longer where it stood")
        moved_m = float(np.linalg.norm(now.world_T_object[:3, 3] - place))
        if moved_m > tolerance_m:
            return Failure.postcondition(f"the {name} was moved", moved_m=moved_m)
    return None
