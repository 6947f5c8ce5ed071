"""Doors and drawers as a look shows them: where the handle goes, and how far it is open."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box, Shape
from kinematics.model.robot_description import Hand
from kinematics.scene.known_part import KnownPart
from kinematics.scene.opening_path import DoorArc, DrawerLine, OpeningPath
from kinematics.scene.planning_scene import FLOOR, PlanningScene, SceneObject
from robots.perception.object_estimate import ObjectEstimate
from robots.scenes.articulated import DOOR, DRAWER, DRAWER_BOTTOM, DRAWER_WALL, HANDLE
from trees.beliefs.scene.believed_thing import PERSON
from trees.beliefs.scene.furniture_pieces import gap_to_solid_m
from trees.beliefs.scene.scene_update import is_name, kind_of

INSIDE_KINDS = (DRAWER_BOTTOM, DRAWER_WALL)
"""What goes with a drawer's front, and shows when it is open."""
BODY_OF: Mapping[str, str] = {DOOR: "fridge", DRAWER: "drawers"}
"""What a door or drawer belongs to, by the kinds that perception tells."""
MEANT_BY: Mapping[str, str] = {
    "fridge": DOOR,
    "refrigerator": DOOR,
    "door": DOOR,
    "cupboard": DOOR,
    "drawer": DRAWER,
    "drawers": DRAWER,
    "chest": DRAWER,
}
"""What is opened when a thing is named."""
OPEN_TO: Mapping[str, float] = {DOOR: math.radians(71.0), DRAWER: 0.30}
"""How far things are opened, rad or m."""
OPEN_ENOUGH: Mapping[str, float] = {DOOR: math.radians(65.5), DRAWER: 0.26}
SHUT: Mapping[str, float] = {DOOR: math.radians(2.5), DRAWER: 0.02}
"""Less open than this is closed, as far as a look can tell."""
CLOSE_TO: Mapping[str, float] = {DOOR: -math.radians(4.0), DRAWER: -0.03}
"""Where a handle is led to close: somewhat beyond, for what the opening was misjudged by."""
_OPEN_SHARE = 0.92
"""Of the whole way of a short drawer, or of a door that opens less far than others."""
_ENOUGH_SHARE = 0.85
"""Of where such a part is opened to: a hand turns about its bar, and a short way is told less exactly."""
_ABOUT_BAR_M = 0.12
"""Farther from a bar no finger is that takes hold of it."""
_PANEL_TO_BODY_M = 0.02
_PAIRED_M = 1.0
"""A handle belongs to the nearest front within this."""
_SAME_FRONT_M = 0.2
"""A front that is farther than this from a handle's way is another one."""
_ONE_BODY_M = 0.1
"""Solids of one piece are as near to its front but for this."""


@dataclass(frozen=True, slots=True)
class HandleTarget:
    """A door or drawer that is to be moved, with the handle that moves it.

    Attributes:
        kind: What it opens.
        handle, part: Names in the planning scene of its bar, and of the door or drawer.
        path: The path that the bar describes when the door or drawer is moved.
        opening: How far it is open, rad or m.
        hands: The hands that can follow it, the better one first.
        unit: The unit that people are told ``opening`` in.
        pushed: Whether a hand pushes against the front, instead of taking hold of the bar; ``handle`` is
            the front itself where the bar is out of sight.
        moves: What is known of it by a model of its piece; None where it is one of the usual kinds.
    """

    kind: Literal["door", "drawer"]
    handle: str
    part: str
    path: OpeningPath
    opening: float
    hands: tuple[Hand, ...]
    pushed: bool = False
    moves: KnownPart | None = None

    @property
    def open_to(self) -> float:
        """How far it is opened, rad or m."""
        usual = OPEN_TO[self.kind]
        return usual if self.moves is None else min(usual, _OPEN_SHARE * self.moves.travel)

    @property
    def open_enough(self) -> float:
        """From where on it counts as open, rad or m."""
        return OPEN_ENOUGH[self.kind] if self.moves is None else _ENOUGH_SHARE * self.open_to

    @property
    def close_to(self) -> float:
        """Where it is led to be closed: a model tells better where it is shut."""
        beyond = CLOSE_TO[self.kind]
        return beyond if self.moves is None else 0.5 * beyond

    @property
    def unit(self) -> str:
        """Unit of openings, for names of numbers."""
        return "deg" if self.kind == DOOR else "m"

    def shown(self, opening: float) -> float:
        """An opening in ``unit``."""
        return math.degrees(opening) if self.kind == DOOR else opening


def without_inside(scene: PlanningScene) -> PlanningScene:
    """A scene without what an open drawer shows behind its front: it goes wherever the handle is led."""
    for name in list(scene.objects):
        if kind_of(name) in INSIDE_KINDS:
            scene = scene.without_object(name)
    return scene


def goes_with(item: SceneObject, target: HandleTarget) -> bool:
    """Whether a part of an open drawer goes with a front: all do, where no models tell several apart."""
    if item.moves is None or target.moves is None:
        return item.moves is target.moves
    return item.moves.is_of(target.moves)


def beside_bar(target: HandleTarget, scene: PlanningScene) -> tuple[str, ...]:
    """What is fixed around the bar of what is known by a model, where it is and where it is while shut.

    Fingers that open no wider than fits may come near it: the next drawer's handle, the table.
    Its own front, the bar itself and people are left out.
    """
    if target.moves is None or target.handle not in scene.objects:
        return ()
    places = (scene.objects[target.handle].world_T_object[:3, 3], target.path.at(0.0).position_m)
    return tuple(
        name
        for name, item in sorted(scene.objects.items())
        if not item.movable
        and not (is_name(name) or kind_of(name) == PERSON)
        and name not in (target.handle, target.part, FLOOR)
        and kind_of(name) not in INSIDE_KINDS
        and min(_away_m(place, item.world_T_object, item.shape) for place in places) <= _ABOUT_BAR_M
    )


def _away_m(place_m: NDArray[np.float64], odom_T_solid: Transform, shape: Shape) -> float:
    """How far a place, shape (3,), is from the box about a solid."""
    size = shape.size_m if isinstance(shape, Box) else (*2 * (2.0 * shape.radius_m,), shape.height_m)
    local = np.abs((place_m - odom_T_solid[:3, 3]) @ odom_T_solid[:3, :3])
    return float(np.linalg.norm(np.maximum(local - 0.5 * np.array(size), 0.0)))


def handles_in(seen: Mapping[str, ObjectEstimate], body: PlanarPose | None = None) -> list[HandleTarget]:
    """Every handle that was seen with its door or drawer.

    Args:
        seen: What a look saw, by name in the planning scene.
        body: Where the robot stands: the hand on the side of a drawer's handle is the better one.
    """
    body = body or PlanarPose()
    fronts = {name: item for name, item in seen.items() if kind_of(name) in BODY_OF}
    found = []
    for name, bar in seen.items():
        if kind_of(name) != HANDLE or not fronts:
            continue
        away = {
            front: float(np.linalg.norm(item.odom_T_object[:3, 3] - bar.odom_T_object[:3, 3]))
            for front, item in fronts.items()
            if _may_have(item, bar)
        }
        nearest = min(away, key=lambda front: (away[front], front), default="")
        if nearest and away[nearest] <= _PAIRED_M:
            found.append(_target(name, bar, nearest, fronts[nearest], seen.values(), body))
    return found


def _may_have(front: ObjectEstimate, bar: ObjectEstimate) -> bool:
    """Whether a bar may be on a front, as far as models tell that."""
    if front.moves is None or bar.moves is None:
        return front.moves is bar.moves
    return front.moves.is_of(bar.moves)


def _misfit_m(
    target: HandleTarget, centre_m: NDArray[np.float64], shape: Shape, moves: KnownPart | None
) -> float:
    """How far a front is from where that of a handle can be, however far it is open.

    Args:
        target: The handle.
        centre_m: Of the front, shape (3,).
        shape: The front's.
        moves: What is known of it by a model.
    """
    path = target.path
    if moves is not None and target.moves is not None:
        return 0.0 if moves.is_same(target.moves) else math.inf
    if isinstance(path, DoorArc):
        half_m = 0.5 * shape.size_m[1] if isinstance(shape, Box) else 0.0
        return abs(float(np.linalg.norm(centre_m[:2] - path.hinge_m)) - half_m)
    closed = path.at(0.0)
    aside = centre_m - closed.position_m
    return math.hypot(float(aside @ closed.across), float(aside[2]))


def same_front(
    target: HandleTarget, fronts: Iterable[HandleTarget], scene: PlanningScene
) -> HandleTarget | None:
    """Of the fronts that a look saw that of a handle, if it is there."""
    away = [
        (_misfit_m(target, item.world_T_object[:3, 3], item.shape, item.moves), one.part, one)
        for one in fronts
        if one.kind == target.kind and (item := scene.objects.get(one.part)) is not None
    ]
    nearest = min(away, default=None)
    return nearest[2] if nearest is not None and nearest[0] <= _SAME_FRONT_M else None


def opening_in(
    estimates: Iterable[ObjectEstimate],
    kind: str,
    known: PlanningScene | None = None,
    target: HandleTarget | None = None,
) -> float | None:
    """How far a door or drawer of a look is open; None when it was not seen, or its body never.

    Args:
        estimates: What the look saw.
        kind: "door" or "drawer".
        known: Where the body is believed to be, for looks that do not see it: it does not move.
        target: Whose handle it is: another's front does not count; None for the only one.
    """
    listed = list(estimates)
    fronts = [item for item in listed if item.kind == kind]
    if target is not None:
        away = [
            (_misfit_m(target, item.odom_T_object[:3, 3], item.shape, item.moves), item) for item in fronts
        ]
        fronts = [item for off_m, item in sorted(away, key=lambda one: one[0]) if off_m <= _SAME_FRONT_M]
    bodies = [(item.odom_T_object, item.shape) for item in listed if item.kind == BODY_OF[kind]]
    if fronts and fronts[0].moves is not None:
        return opening_of(kind, fronts[0], [])
    if not bodies and known is not None:
        believed = [item for name, item in known.objects.items() if kind_of(name) == BODY_OF[kind]]
        bodies = [(item.world_T_object, item.shape) for item in believed]
    if not fronts or not bodies:
        return None
    return opening_of(kind, fronts[0], bodies)


def top_of_nearest(
    place_m: NDArray[np.float64], bodies: list[tuple[Transform, Shape]]
) -> tuple[Transform, Shape]:
    """Of all solids of chests, or of fridges, the top of the one that is nearest to a front.

    Args:
        place_m: Of the front, shape (3,).
        bodies: Poses and shapes of the solids, at least one.
    """
    gaps = [gap_to_solid_m(place_m, pose, shape) for pose, shape in bodies]
    near = [body for gap_m, body in zip(gaps, bodies, strict=True) if gap_m <= min(gaps) + _ONE_BODY_M]
    return max(near, key=lambda item: float(item[0][2, 3]))


def opening_of(kind: str, front: ObjectEstimate, bodies: list[tuple[Transform, Shape]]) -> float:
    """How far a front is open, from its pose and those of what it closes; x of all points inwards.

    Args:
        kind: "door" or "drawer".
        front: Its front.
        bodies: Of what is known by a model none is needed.
    """
    if front.moves is not None:
        return _opening_by_model(front.odom_T_object, front.moves)
    body, shape = top_of_nearest(front.odom_T_object[:3, 3], bodies)
    yaw = poses.yaw_of(body[:3, :3])
    if kind == DOOR:
        turned = poses.yaw_of(front.odom_T_object[:3, :3]) - yaw
        return abs((turned + math.pi) % (2.0 * math.pi) - math.pi)
    inwards = poses.rotation_z(yaw)[:, 0]
    depth_m = shape.size_m[0] if isinstance(shape, Box) else 0.0
    to_front_m = float((body[:3, 3] - front.odom_T_object[:3, 3]) @ inwards)
    return max(0.0, to_front_m - 0.5 * depth_m - _PANEL_TO_BODY_M)


def _opening_by_model(odom_T_front: Transform, moves: KnownPart) -> float:
    """How far a front is from where a model has it shut."""
    shut_T_front = poses.inverse(moves.shut) @ odom_T_front
    if moves.side:
        return max(0.0, -moves.side * poses.yaw_of(shut_T_front[:3, :3]))
    return max(0.0, -float(shut_T_front[0, 3]))


def _target(
    name: str,
    bar: ObjectEstimate,
    part: str,
    front: ObjectEstimate,
    seen: Iterable[ObjectEstimate],
    body: PlanarPose,
) -> HandleTarget:
    kind = kind_of(part)
    listed = list(seen)
    bodies = [(item.odom_T_object, item.shape) for item in listed if item.kind == BODY_OF[kind]]
    opening = opening_of(kind, front, bodies) if bodies or front.moves is not None else 0.0
    place, panel = bar.odom_T_object[:3, 3], front.odom_T_object
    inwards, left = panel[:3, 0], panel[:3, 1]
    if (place - panel[:3, 3]) @ inwards > 0.0:  # a handle is in front of what it opens
        inwards, left = -inwards, -left
    yaw = math.atan2(inwards[1], inwards[0])
    if kind == DRAWER:
        line = DrawerLine(place, yaw).through(place, opening)
        aside_m = body.to(PlanarPose(float(place[0]), float(place[1]))).y_m
        first: Hand = "left" if aside_m > 0.0 else "right"
        return HandleTarget(
            DRAWER,
            name,
            part,
            line,
            opening,
            (first, "right" if first == "left" else "left"),
            moves=front.moves,
        )
    side = -1.0 if (place - panel[:3, 3]) @ left > 0.0 else 1.0
    width_m = front.shape.size_m[1] if isinstance(front.shape, Box) else 0.0
    hinge = panel[:2, 3] + 0.5 * width_m * side * left[:2]
    if front.moves is not None:
        side, hinge = front.moves.side, (panel @ np.array([*front.moves.hinge_m, 0.0, 1.0]))[:2]
    arc = DoorArc(hinge, yaw + side * opening, side, 0.0, 0.0, 0.0).through(place, opening)
    hands: tuple[Hand, ...] = ("left", "right") if side > 0.0 else ("right", "left")
    if front.moves is None:  # a large door is led by the hand on the side of its hinge alone
        hands = hands[:1]
    return HandleTarget(DOOR, name, part, arc, opening, hands, moves=front.moves)
