"""Doors, drawers and what they belong to, as the world model remembers them."""

from __future__ import annotations

from collections.abc import Mapping

from kinematics.geometry.planar import PlanarPose
from kinematics.scene.planning_scene import PlanningScene
from robots.perception.object_estimate import ObjectEstimate
from robots.scenes.articulated import PART_KINDS
from trees.beliefs.openings.handles import BODY_OF, HandleTarget, handles_in
from trees.beliefs.scene.scene_update import kind_of
from trees.skills.doors.pushed_front import fronts_in


def known_parts(scene: PlanningScene, body: PlanarPose, pushed: bool) -> list[HandleTarget]:
    """Every door and drawer that was seen, now or before; of those that are pushed, every door.

    Args:
        scene: What is believed.
        body: Where the robot stands.
        pushed: Whether a door's front is enough, without its handle.
    """
    seen = _remembered(scene)
    return fronts_in(seen) if pushed else handles_in(seen, body)


def _remembered(scene: PlanningScene) -> Mapping[str, ObjectEstimate]:
    parts = {*PART_KINDS, *BODY_OF.values()}
    return {
        name: ObjectEstimate("furniture", kind_of(name), None, item.world_T_object, item.shape, 0.5, 0, 0.0)
        for name, item in scene.objects.items()
        if kind_of(name) in parts
    }
