"""Doors as they are pushed shut: known by their front and by what they belong to, without the handle."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box
from kinematics.model.robot_description import Hand
from kinematics.scene.opening_path import DoorArc
from kinematics.scene.planning_scene import PlanningScene
from robots.perception.object_estimate import ObjectEstimate
from robots.scenes.articulated import DOOR, PART_KINDS
from trees.beliefs.openings.handles import BODY_OF, HandleTarget, handles_in, top_of_nearest
from trees.beliefs.scene.scene_update import kind_of

PUSH_TO_RAD = -0.12
"""Where a pushing hand is led: the frame stops the door before; which part of the hand will touch it there
is not known to some centimetres."""
_TOLD_RAD, _MOST_RAD = 0.12, 2.3
"""From which angle on a panel alone tells its hinge; beyond the other it was seen the wrong way round."""


def fronts_in(seen: Mapping[str, ObjectEstimate]) -> list[HandleTarget]:
    """Every door that was seen with what it belongs to; with its bar, where that was seen too.

    Args:
        seen: What a look saw, by name in the planning scene.
    """
    known = {target.part: replace(target, pushed=True) for target in handles_in(seen)}
    bodies = [item for item in seen.values() if item.kind == BODY_OF[DOOR]]
    found = []
    for name, panel in seen.items():
        if kind_of(name) == DOOR and bodies:
            target = known.get(name) or _front(name, panel, bodies)
            if target is not None:
                found.append(target)
    return found


def _front(name: str, panel: ObjectEstimate, bodies: list[ObjectEstimate]) -> HandleTarget | None:
    """The hinge is where an edge of the panel meets a front corner of the body; x of both points inwards.

    None for a door that is nearly closed, and might hang on either side.
    """
    body, shape = top_of_nearest(
        panel.odom_T_object[:3, 3], [(item.odom_T_object, item.shape) for item in bodies]
    )
    if not (isinstance(shape, Box) and isinstance(panel.shape, Box)):
        return None
    depth_m, wide_m, _ = shape.size_m
    inwards, left = body[:2, 0], body[:2, 1]
    centre, middle = body[:2, 3], panel.odom_T_object[:2, 3]
    half = 0.5 * panel.shape.size_m[1] * panel.odom_T_object[:2, 1]
    _, side, hinge = min(
        (
            (
                float(np.linalg.norm(edge - (centre - 0.5 * depth_m * inwards + 0.5 * side * wide_m * left))),
                side,
                edge,
            )
            for side in (1.0, -1.0)
            for edge in (middle + half, middle - half)
        ),
        key=lambda item: item[0],
    )
    yaw = poses.yaw_of(body[:3, :3])
    turned = yaw - poses.yaw_of(panel.odom_T_object[:3, :3])
    for opening in (side * turned, side * turned + math.pi):
        opening = (opening + math.pi) % (2.0 * math.pi) - math.pi
        if _TOLD_RAD <= opening <= _MOST_RAD:
            arc = DoorArc(
                hinge, yaw, side, 0.5 * panel.shape.size_m[1], 0.0, float(panel.odom_T_object[2, 3])
            )
            hand: Hand = "left" if side > 0.0 else "right"
            return HandleTarget(DOOR, name, name, arc, opening, (hand,), pushed=True)
    return None


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
