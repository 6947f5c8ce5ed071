"""What is pushed shut: known by its front and by what that belongs to, without the handle."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box
from kinematics.model.handle_settings import Pushing
from kinematics.model.robot_description import Hand
from kinematics.scene.known_part import KnownPart
from kinematics.scene.opening_path import DoorArc, DrawerLine
from kinematics.scene.planning_scene import PlanningScene
from robots.perception.object_estimate import ObjectEstimate
from robots.scenes.articulated import DOOR, DRAWER, HANDLE, PART_KINDS
from trees.beliefs.openings.handles import (
    BODY_OF,
    HandleTarget,
    handles_in,
    opening_of,
    top_of_nearest,
)
from trees.beliefs.scene.scene_update import kind_of

_BAR_OFF_M = 0.12
"""A bar is no farther than this before its front."""
_LARGE_M = 0.45
"""A door that is less high has no room for a hand beside its bar."""
_TOLD_RAD, _MOST_RAD = 0.12, 2.3
"""From which angle on a panel alone tells its hinge; beyond the other it was seen the wrong way round."""


def fronts_in(seen: Mapping[str, ObjectEstimate], drawers: bool = False) -> list[HandleTarget]:
    """Every front that was seen with what it belongs to; with its bar, where that was seen too.

    Args:
        seen: What a look saw, by name in the planning scene.
        drawers: Whether those of drawers count.
    """
    known = {target.part: replace(target, pushed=True) for target in handles_in(seen)}
    found = []
    for name, panel in seen.items():
        kind = kind_of(name)
        bodies = [item for item in seen.values() if item.kind == BODY_OF.get(kind)]
        if kind not in ((DOOR, DRAWER) if drawers else (DOOR,)) or not (bodies or panel.moves):
            continue
        target = known.get(name) or (_door if kind == DOOR else _drawer)(name, panel, bodies)
        if target is not None:
            found.append(target)
    return found


def _drawer(name: str, panel: ObjectEstimate, bodies: list[ObjectEstimate]) -> HandleTarget:
    """A drawer by its front; x of that and of what it is in points inwards."""
    solids = [(item.odom_T_object, item.shape) for item in bodies]
    middle, opening = panel.odom_T_object[:3, 3], opening_of(DRAWER, panel, solids)
    line = DrawerLine(middle, poses.yaw_of(panel.odom_T_object[:3, :3])).through(middle, opening)
    return HandleTarget(DRAWER, name, name, line, opening, ("left", "right"), pushed=True, moves=panel.moves)


def _door(name: str, panel: ObjectEstimate, bodies: list[ObjectEstimate]) -> HandleTarget | None:
    """The hinge is where an edge of the panel meets a front corner of the body; x of both points inwards.

    None for a door that is nearly closed, and might hang on either side; a model of its piece tells that.
    """
    if panel.moves is not None:
        return _door_by_model(name, panel, panel.moves)
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


def _door_by_model(name: str, panel: ObjectEstimate, front: KnownPart) -> HandleTarget:
    """A door whose hinge a model tells, with the middle of its front for a bar."""
    hinge = (panel.odom_T_object @ np.array([*front.hinge_m, 0.0, 1.0]))[:2]
    opening, middle = opening_of(DOOR, panel, []), panel.odom_T_object[:3, 3]
    yaw = poses.yaw_of(front.shut[:3, :3])
    arc = DoorArc(hinge, yaw, front.side, 0.0, 0.0, 0.0).through(middle, opening)
    hand: Hand = "left" if front.side > 0.0 else "right"
    return HandleTarget(DOOR, name, name, arc, opening, (hand,), pushed=True, moves=front)


def is_pushed(front: ObjectEstimate, pushing: Pushing) -> bool:
    """Whether a hand finds room on a door where it pushes such things: not on that of a microwave."""
    if not isinstance(front.shape, Box):
        return True
    _, width_m, height_m = front.shape.size_m
    return height_m >= _LARGE_M and any(away_m <= width_m for away_m, _ in pushing.places_m)


def with_known_bars(fronts: Sequence[HandleTarget], scene: PlanningScene) -> list[HandleTarget]:
    """Fronts with their bars, where these are out of sight now and were seen before: a bar moves along."""
    bars = [name for name in scene.objects if kind_of(name) == HANDLE]
    return [
        next((replace(one, handle=bar) for bar in bars if _is_on(one.part, bar, scene)), one)
        if one.handle == one.part
        else one
        for one in fronts
    ]


def _is_on(part: str, bar: str, scene: PlanningScene) -> bool:
    """Whether a bar is where those of a front can be, as that is now."""
    front = scene.objects[part]
    if not isinstance(front.shape, Box):
        return False
    off = poses.inverse(front.world_T_object) @ scene.objects[bar].world_T_object[:, 3]
    return bool(
        abs(off[0]) <= _BAR_OFF_M and np.all(np.abs(off[1:3]) <= 0.5 * np.array(front.shape.size_m[1:]))
    )


def known_parts(
    scene: PlanningScene, body: PlanarPose, pushed: bool, drawers: bool = False
) -> list[HandleTarget]:
    """Every door and drawer that was seen, now or before; of those that are pushed, every front.

    Args:
        scene: What is believed.
        body: Where the robot stands.
        pushed: Whether a front is enough, without its handle.
        drawers: Whether drawers are pushed too.
    """
    seen = _remembered(scene)
    return fronts_in(seen, drawers) if pushed else handles_in(seen, body)


def _remembered(scene: PlanningScene) -> Mapping[str, ObjectEstimate]:
    parts = {*PART_KINDS, *BODY_OF.values()}
    return {
        name: ObjectEstimate(
            "furniture",
            kind_of(name),
            None,
            item.world_T_object,
            item.shape,
            0.5,
            0,
            0.0,
            moves=item.moves,
        )
        for name, item in scene.objects.items()
        if kind_of(name) in parts
    }
