"""What a hand that felt nothing tells about what should have carried its object."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from kinematics.geometry import poses
from kinematics.scene.planning_scene import PlanningScene
from kinematics.scene.support_of import top_m


def lowered_supports(scene: PlanningScene, names: Iterable[str], below_m: float) -> PlanningScene:
    """The scene with furniture no higher than what was lowered onto it and did not touch it.

    Fingers keep a margin from a top for the error of its height; a top that is known to be lower than it
    seemed would keep them from going on by an error that it has not got.

    Args:
        scene: As it was seen.
        names: Of what should have carried the object; what is no furniture is left as it is.
        below_m: Height of the object's lowest point.
    """
    for name in names:
        item = scene.objects.get(name)
        if item is None or item.movable or top_m(item) <= below_m:
            continue
        down = poses.translation(0.0, 0.0, below_m - top_m(item))
        scene = scene.with_object(replace(item, world_T_object=down @ item.world_T_object))
    return scene
