"""Where to stand for what comes next: in front of furniture, within reach of an object, before a person."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.scene.support_of import support_of, top_m
from kinematics.walking.route.path_planning import clearance_m, footprints
from kinematics.walking.route.room import WalkingRoom
from robots.scenes.person_solid import PERSON_REACH_M
from trees.beliefs.grounding.destination import Place
from trees.beliefs.scene.furniture_pieces import are_one_piece

EDGE_M = 0.34
"""From the middle between the feet to a table's edge: picks reach best from 0.29 to 0.36, and the
fingertips of the home posture stand out by 0.20."""
PERSON_M = 1.1
FREE_M = 0.7
"""From something that stands on the floor by itself."""
_TALL_M, _TALL_EDGE_M = 1.3, 1.0
"""From what is taller than this one stands farther away: before the eyes it would hide itself, and a door
opens towards whoever stands there."""
_FROM_CORNER_M = 0.25
_FROM_BORDER_M = 0.4
"""Who stands in a room stands so far inside it,"""
_SPOT_M = 0.05
"""or so near to its middle where it is no larger than that."""
_ROOM_M = 0.8
_GRID_M = 0.25
_ASIDE_RAD = tuple(math.radians(10.0 * k) for k in range(-9, 10))
_STEPS_M = tuple(0.1 * k for k in range(-5, 6))
_BEHIND_M = tuple(0.05 * k for k in range(9))
_BEFORE_M = tuple(0.03 * k for k in range(11))
"""From between the feet towards the edge of what one stands before: a wall there is between the two,"""
_THIN_M = 0.02
"""or one that is so near to these points, however thin."""
_BESIDE = sorted(
    (PlanarPose(-back, aside) for back in _STEPS_M if back >= 0.0 for aside in _STEPS_M),
    key=lambda beside: math.hypot(beside.x_m, beside.y_m),
)
_HERE_M = 0.05
_SPARE_M, _SPARE_HERE_M = 0.08, 0.04
"""Beside the hands of who stands before furniture, the latter where he stands so already."""
_BESIDE_LOAD_M = 0.03
"""Beside what a hand holds, that is still where it was lifted to: the sides of a shelf are as tall."""
_TIGHT_COST_RAD_M = 20.0
"""A place to stand that is too tight by 1 cm is worth going around by 11 degrees."""


def standing_place(
    place: Place,
    scene: PlanningScene,
    body: PlanarPose,
    support_gap_m: float,
    room: WalkingRoom | None = None,
    points: Array | None = None,
) -> PlanarPose:
    """The pose of the body, in the odometry frame, facing what the task is about.

    Args:
        place: What it is about.
        scene: For what an object stands on.
        body: Where the body is now; the nearest side is chosen.
        support_gap_m: As for ``support_of``.
        room: What a robot that walks takes: before a person it needs room to turn.
        points: Where in a region something stands that is not in the scene, shape (n, 2).
    """
    x, y = float(place.odom_T_place[0, 3]), float(place.odom_T_place[1, 3])
    if place.category == "region" and isinstance(place.shape, Box):
        return _inside(place.shape, PlanarPose.of(place.odom_T_place), scene, points)
    if place.category == "furniture" and isinstance(place.shape, Box):
        sides = sides_of(place.shape, place.odom_T_place, body, edge_m=edge_m(_height_m(place, scene)))
        if room is None:
            return sides[0]
        return _where_hands_are_free(_first_open(sides, scene, room), body, scene, room)
    if place.category == "object":
        item = SceneObject(place.name, place.shape, place.odom_T_place)
        under = support_of(item, scene, support_gap_m)
        if under is not None and isinstance(under.shape, Box):
            sides = sides_of(under.shape, under.world_T_object, PlanarPose(x, y), toward=PlanarPose(x, y))
            return sides[0] if room is None else _first_open(sides, scene, room)
    return _around(place, PERSON_M if place.category == "person" else FREE_M, body, scene, room)


def _where_hands_are_free(
    usual: PlanarPose, body: PlanarPose, scene: PlanningScene, room: WalkingRoom
) -> PlanarPose:
    """The usual place before furniture, or the nearest one where hands and load come to nothing.

    Say to an open door, or to a shelf's side. At home or drawn in: whichever way the robot comes; drawn in,
    they can turn away as well. One that stands well is not sent on for a centimetre.
    """
    rooms = room.either_way()

    def free(stand: PlanarPose, spare_m: float) -> bool:
        turns = rooms[-1].hands_turn(scene, stand, spare_m - _SPARE_M)
        empty = turns and not any(one.hands_meet(scene, [stand], spare_m) for one in rooms)
        return empty and not room.load_meets(scene, [stand], _BESIDE_LOAD_M)

    if free(usual, _SPARE_M):
        return usual
    stands = [usual @ beside for beside in _BESIDE]
    here = min(stands, key=body.distance_m)
    if here.distance_m(body) < _HERE_M and free(here, _SPARE_HERE_M):
        return here
    roomy = [one for one in stands if free(one, _SPARE_M)]
    with_room = (one for one in roomy if rooms[-1].tightest(scene, one).lack_m <= 0.0)
    loaded = room.load_meets(scene, [usual], _BESIDE_LOAD_M)
    return next(with_room, next(iter(roomy if loaded else ()), usual))


def _around(
    place: Place, away_m: float, body: PlanarPose, scene: PlanningScene, room: WalkingRoom | None
) -> PlanarPose:
    """On a circle around something, facing it: on this side of it, or where there is room to turn."""
    x, y = float(place.odom_T_place[0, 3]), float(place.odom_T_place[1, 3])
    direct = math.atan2(y - body.y_m, x - body.x_m)

    def before(heading: float) -> PlanarPose:
        gap_m = away_m + _beyond_m(place, heading)
        return PlanarPose(x - gap_m * math.cos(heading), y - gap_m * math.sin(heading), heading)

    if room is None:
        return before(direct)
    if place.name in scene.objects:
        scene = scene.without_object(place.name)
    best = (math.inf, PlanarPose())
    for aside in sorted(_ASIDE_RAD, key=abs):
        stand = before(direct + aside)
        cost = abs(aside) + _TIGHT_COST_RAD_M * max(0.0, room.tightest(scene, stand, at_ease=True).lack_m)
        if cost < best[0]:
            best = (cost, stand)
    return best[1]


def _beyond_m(place: Place, heading: float) -> float:
    """How much farther somebody who lies reaches, towards who comes along a heading, than who stands."""
    if place.category != "person" or not isinstance(place.shape, Box):
        return 0.0
    along = heading - poses.yaw_of(place.odom_T_place[:3, :3])
    half_x, half_y = 0.5 * place.shape.size_m[0], 0.5 * place.shape.size_m[1]
    c, s = max(abs(math.cos(along)), 1e-9), max(abs(math.sin(along)), 1e-9)
    return max(0.0, min(half_x / c, half_y / s) - PERSON_REACH_M)


def edge_m(height_m: float) -> float:
    """How far from the edge of a piece of furniture one stands, by its height."""
    return _TALL_EDGE_M if height_m >= _TALL_M else EDGE_M


def stands_inside(place: Place, body: PlanarPose) -> bool:
    """Whether the body is well inside a region."""
    seen = PlanarPose.of(place.odom_T_place).to(body)
    half_x, half_y = (0.5 * size for size in getattr(place.shape, "size_m", (0.0, 0.0))[:2])
    room_x, room_y = (max(half - _FROM_BORDER_M, _SPOT_M) for half in (half_x, half_y))
    return abs(seen.x_m) <= room_x and abs(seen.y_m) <= room_y


def _height_m(place: Place, scene: PlanningScene) -> float:
    """Of the highest solid of a piece of furniture; boards and sides have the same word and number apart."""
    this = SceneObject(place.name, place.shape, place.odom_T_place)
    pieces = (item for item in scene.objects.values() if not item.movable and are_one_piece(this, item))
    tops = [top_m(item) for item in pieces]
    return max(tops, default=float(place.odom_T_place[2, 3]))


def _inside(box: Box, middle: PlanarPose, scene: PlanningScene, points: Array | None) -> PlanarPose:
    """The place nearest to the middle of a region with room around it, facing as the region does."""
    known = footprints(scene)
    reach_x, reach_y = (max(0.0, 0.5 * size - _FROM_BORDER_M) for size in box.size_m[:2])
    best = (math.inf, middle)
    for x in np.arange(-reach_x, reach_x + 1e-9, _GRID_M):
        for y in np.arange(-reach_y, reach_y + 1e-9, _GRID_M):
            place = middle @ PlanarPose(float(x), float(y))
            free_m = min(clearance_m(known, place), _from_points_m(points, place))
            tight_m = max(0.0, _ROOM_M - free_m)
            cost = math.hypot(x, y) + 10.0 * tight_m
            if cost < best[0] - 1e-9:
                best = (cost, place)
    return best[1]


def _from_points_m(points: Array | None, place: PlanarPose) -> float:
    if points is None or not len(points):
        return math.inf
    return float(np.hypot(points[:, 0] - place.x_m, points[:, 1] - place.y_m).min())


def sides_of(
    box: Box,
    odom_T_box: poses.Transform,
    near: PlanarPose,
    toward: PlanarPose | None = None,
    edge_m: float = EDGE_M,
) -> list[PlanarPose]:
    """Square in front of each side of a box, level with a point of it; the nearest side first."""
    middle = PlanarPose.of(odom_T_box)
    seen = middle.to(toward or near)
    half_x, half_y = 0.5 * box.size_m[0], 0.5 * box.size_m[1]
    sides = {
        # how far the point is from each side, where to stand, and along which axis one may slide
        0.0: (half_x - seen.x_m if toward else -(seen.x_m - half_x), half_x, half_y, seen.y_m),
        math.pi: (half_x + seen.x_m if toward else seen.x_m + half_x, half_x, half_y, -seen.y_m),
        0.5 * math.pi: (half_y - seen.y_m if toward else -(seen.y_m - half_y), half_y, half_x, -seen.x_m),
        -0.5 * math.pi: (half_y + seen.y_m if toward else seen.y_m + half_y, half_y, half_x, seen.x_m),
    }
    stands = []
    for outward in sorted(sides, key=lambda angle: sides[angle][0]):
        _, out_m, wide_m, along_m = sides[outward]
        room_m = max(0.0, wide_m - _FROM_CORNER_M)
        along_m = float(np.clip(along_m if toward else 0.0, -room_m, room_m))
        stands.append(middle @ PlanarPose(yaw_rad=outward) @ PlanarPose(out_m + edge_m, along_m, math.pi))
    return stands


def _first_open(sides: Sequence[PlanarPose], scene: PlanningScene, room: WalkingRoom) -> PlanarPose:
    """The first of some sides of furniture that one can walk to; the first at all where there is none."""
    return next((side for side in sides if _is_open(side, scene, room)), sides[0])


def _is_open(side: PlanarPose, scene: PlanningScene, room: WalkingRoom) -> bool:
    """Whether there is room to turn close behind where one stands, and no wall before: else no way leads."""
    fixed = scene.with_objects(item for item in scene.objects.values() if not item.movable)
    before = np.array([(at.x_m, at.y_m) for at in (side @ PlanarPose(ahead) for ahead in _BEFORE_M)])
    if any(float(one.distance_m(before).min()) <= _THIN_M for one in footprints(fixed)):
        return False
    narrow = room.either_way()[-1]
    return any(narrow.tightest(scene, side @ PlanarPose(-back)).lack_m <= 0.0 for back in _BEHIND_M)
