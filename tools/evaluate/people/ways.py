"""Random ways of people through the flat, such as a robot can walk behind them."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from functools import cache
from itertools import pairwise

import numpy as np

from kinematics.geometry.planar import PlanarPose
from kinematics.walking.route.path_planning import Footprint, clearance_m, footprints, plan_path
from robots.errors import SceneError
from robots.scenes.scene_description import Person, RobotStart, SceneDescription
from robots.scenes.scene_file import load_scene, read_scene
from robots.scenes.scene_solids import planning_scene
from robots.scenes.scene_writer import dump

Point = tuple[float, float]

BESIDE_M = 0.75
"""A way stays so far from furniture: there is room for the robot behind."""
SHARPEST_RAD = math.radians(100.0)
"""Nobody turns back farther than this at a corner: who does walks into the robot behind."""
AWAY_M = 1.1
"""Nobody comes nearer to where the robot stands at first."""
_FROM_BYSTANDER_M = 1.3
_WALLS_M = 0.55
_DRAWS = 2000


def free_place(rng: np.random.Generator, room: str, from_m: float) -> Point | None:
    """A place in a room that is so far from all furniture; None for a draw without luck."""
    region = next(one for one in furnished().places if one.name == room)
    half = 0.5 * np.array(region.size_m) - _WALLS_M
    x, y = (np.array(region.position_m) + rng.uniform(-half, half)).tolist()
    return (x, y) if is_free((x, y), from_m) else None


def is_free(place: Point, from_m: float = 0.5) -> bool:
    """Whether a place is so far from all furniture."""
    return clearance_m(_furniture(), PlanarPose(*place)) >= from_m


def way_to(start: Point, end: Point) -> tuple[Point, ...] | None:
    """The corners of a way through the furniture, the end last; None where there is none."""
    path = plan_path(PlanarPose(*start), PlanarPose(*end), _furniture(), BESIDE_M)
    return None if path is None else tuple((pose.x_m, pose.y_m) for pose in path[1:])


def length_m(start: Point, way: Sequence[Point]) -> float:
    """How long a way is."""
    return sum(math.dist(a, b) for a, b in pairwise((start, *way)))


def is_walked_away(start: Point, way: Sequence[Point], robot: Point) -> bool:
    """Whether somebody who goes a way keeps away from the robot, and never turns back on it."""
    points = (start, *way)
    headings = [math.atan2(b[1] - a[1], b[0] - a[0]) for a, b in pairwise(points)]
    away = math.atan2(start[1] - robot[1], start[0] - robot[0])
    turns = [math.remainder(b - a, math.tau) for a, b in pairwise((away, *headings))]
    kept = all(_distance_m(robot, a, b) >= min(AWAY_M, math.dist(start, robot)) for a, b in pairwise(points))
    return kept and all(abs(turn) <= SHARPEST_RAD for turn in turns)


def bystander(rng: np.random.Generator, name: str, ways: Sequence[Point]) -> Person | None:
    """Somebody who stands about, away from ways; None for a draw without luck."""
    room = ("kitchen", "living room")[int(rng.integers(2))]
    place = free_place(rng, room, 0.45)
    if place is None or min(_distance_m(place, a, b) for a, b in pairwise(ways)) < _FROM_BYSTANDER_M:
        return None
    return Person(name, place, float(rng.uniform(-math.pi, math.pi)))


@cache
def furnished() -> SceneDescription:
    """The flat without anybody."""
    return dataclasses.replace(load_scene("flat"), people=())


def peopled(start: RobotStart, people: Sequence[Person]) -> SceneDescription | None:
    """The flat with the robot and some people, as its file says it; None where that cannot be."""
    full = dataclasses.replace(furnished(), robot_start=start, people=tuple(people))
    try:
        return read_scene(dump(full), "episode in the flat", "flat")
    except SceneError:
        return None


def tries() -> range:
    """How often something is drawn before there is taken to be none."""
    return range(_DRAWS)


@cache
def _furniture() -> tuple[Footprint, ...]:
    return footprints(planning_scene(furnished()))


def _distance_m(point: Point, a: Point, b: Point) -> float:
    dx, dy = b[0] - a[0], b[1] - a[1]
    length = max(dx * dx + dy * dy, 1e-12)
    share = min(max(((point[0] - a[0]) * dx + (point[1] - a[1]) * dy) / length, 0.0), 1.0)
    return math.dist(point, (a[0] + share * dx, a[1] + share * dy))
