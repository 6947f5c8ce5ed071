"""Free spots on a top: where an object could stand without touching anything else."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array, Sealed
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Shape
from kinematics.scene.planning_scene import PlanningScene, SceneObject

# Neighbours farther than this are no hindrance to a hand.
ROOM_M = 0.12
ROOM_COST = 1.0
GRID_M = 0.03
# Two spots nearer than this are one choice.
APART_M = 0.05
MOST = 12
_ON_TOP_M = 0.04
_UPRIGHT = 0.99


@dataclass(frozen=True, slots=True)
class _Room:
    """What is left around an object's foot; less is tried where with more nothing is free.

    Attributes:
        edge_m: To the edge of the top.
        gap_m: To its neighbours: a perception error of each, and a finger beside it.
        beside_m: To what it goes beside, all that are tried.
        off_rad: How far off the named direction is tried. Within 45 degrees it is more in that direction than
            in any other.
    """

    edge_m: float
    gap_m: float
    beside_m: tuple[float, ...]
    off_rad: float


EDGE_M, GAP_M = 0.03, 0.05
_ENOUGH = _Room(EDGE_M, GAP_M, (0.06, 0.09, 0.13, 0.17), math.radians(40.0))
_TIGHT = _Room(0.01, 0.04, (0.045, 0.06, 0.09), math.radians(45.0))
"""So near to an edge things stand as well, be they 1 cm beside where they were meant to be."""
_TURN_RAD = math.radians(15.0)


@dataclass(frozen=True, slots=True)
class FreeSpot(Sealed):
    """A place on the top of a piece of furniture where there is room for an object.

    Attributes:
        place_m: The point on the top, in the world, shape (3,).
        cost: What speaks against it, such as its distance from where the object is wanted; smaller is
            better, no unit.
    """

    place_m: Array
    cost: float


def footprint_radius_m(shape: Shape) -> float:
    """Of the circle around an upright object's foot."""
    if isinstance(shape, Box):
        return 0.5 * math.hypot(shape.size_m[0], shape.size_m[1])
    return shape.radius_m


def spots_on(
    top: SceneObject,
    scene: PlanningScene,
    radius_m: float,
    wish: Callable[[Array], float],
    known: Callable[[Array], bool] = lambda _place: True,
    at: Sequence[Array] = (),
) -> list[FreeSpot]:
    """Free spots anywhere on a top, the most wished for first.

    Args:
        top: An upright box.
        scene: Everything that may stand there.
        radius_m: Of the object's foot.
        wish: Cost of a place, shape (3,).
        known: Whether all that stands about a place, shape (3,), is in the scene.
        at: Places that are tried besides those of a grid, each of shape (2,), in the top's frame.
    """
    for room in (_ENOUGH, _TIGHT):
        half = _half_m(top, radius_m, room)
        if np.all(half >= 0.0):
            axes = [np.linspace(-h, h, max(1, int(2.0 * h / GRID_M)) + 1) for h in half]
            places = [_on(top, x, y) for x in axes[0] for y in axes[1]]
            places += [_on(top, x, y) for x, y in at if np.all(np.abs((x, y)) <= half)]
            if free := _free(places, top, scene, radius_m, room, wish):
                return _chosen(free, known)
    return []


def spots_beside(
    other: SceneObject,
    top: SceneObject,
    scene: PlanningScene,
    radius_m: float,
    directions_rad: Sequence[float],
    wish: Callable[[Array], float],
    known: Callable[[Array], bool] = lambda _place: True,
) -> list[FreeSpot]:
    """Free spots beside an object, in one of some directions from it, nearest to those directions first.

    Args:
        other: What it goes beside.
        top: What that stands on.
        scene: Everything that may stand there.
        radius_m: Of the object's foot.
        directions_rad: World headings from ``other``, the most wished for first.
        wish: Further cost of a place, shape (3,).
        known: As for ``spots_on``.
    """
    for room in (_ENOUGH, _TIGHT):
        costs = _costs_beside(other, radius_m, directions_rad, room)
        if free := _free_beside(costs, top, scene, radius_m, room, wish):
            return _chosen(free, known)
    return []


def _costs_beside(
    other: SceneObject, radius_m: float, directions_rad: Sequence[float], room: _Room
) -> dict[tuple[float, float], float]:
    """Places beside an object, in the world, and how far each is from what was named."""
    centre = other.world_T_object[:2, 3]
    apart_m = footprint_radius_m(other.shape) + radius_m
    costs: dict[tuple[float, float], float] = {}
    for rank, direction in enumerate(directions_rad):
        for gap in room.beside_m:
            for turn in _turns_rad(room.off_rad):
                way = np.array([math.cos(direction + turn), math.sin(direction + turn)])
                x, y = (float(value) for value in centre + (apart_m + gap) * way)
                costs[x, y] = 0.5 * rank + abs(turn) + 2.0 * (gap - room.beside_m[0])
    return costs


def _turns_rad(off_rad: float) -> list[float]:
    """The named direction, then others to both sides of it, up to the last ones."""
    to_a_side = [*np.arange(_TURN_RAD, off_rad, _TURN_RAD).tolist(), off_rad]
    return [0.0, *(side * turn for turn in to_a_side for side in (1.0, -1.0))]


def _free_beside(
    costs: Mapping[tuple[float, float], float],
    top: SceneObject,
    scene: PlanningScene,
    radius_m: float,
    room: _Room,
    wish: Callable[[Array], float],
) -> list[FreeSpot]:
    """Those of some places that are free and on a top; the cheapest first."""
    half = _half_m(top, radius_m, room)
    places = []
    for x, y in costs:
        local = poses.inverse(top.world_T_object) @ np.array([x, y, 0.0, 1.0])
        if np.all(np.abs(local[:2]) <= half):
            places.append(_on(top, float(local[0]), float(local[1])))

    def cost(place: Array) -> float:
        nearest = min(costs, key=lambda xy: math.hypot(place[0] - xy[0], place[1] - xy[1]))
        return costs[nearest] + 0.3 * wish(place)

    return _free(places, top, scene, radius_m, room, cost)


def _half_m(top: SceneObject, radius_m: float, room: _Room) -> Array:
    """How far from its middle a foot may be on a top, shape (2,); negative where it has no room."""
    size_m = top.shape.size_m[:2] if isinstance(top.shape, Box) else (0.0, 0.0)
    return np.asarray(0.5 * np.array(size_m) - radius_m - room.edge_m)


def _on(top: SceneObject, x: float, y: float) -> Array:
    place = top.world_T_object @ np.array([x, y, 0.5 * top.shape.height_m, 1.0])
    return np.asarray(place[:3])


def _free(
    places: Iterable[Array],
    top: SceneObject,
    scene: PlanningScene,
    radius_m: float,
    room: _Room,
    wish: Callable[[Array], float],
) -> list[FreeSpot]:
    """Those of some places where nothing stands, the cheapest first."""
    height = float(top.world_T_object[2, 3]) + 0.5 * top.shape.height_m
    around = [item for item in scene.objects.values() if item.name != top.name and _stands_at(item, height)]
    listed = list(places)
    free = []
    for place, gap in zip(listed, _gaps_m(listed, around, radius_m), strict=True):
        if gap >= room.gap_m:
            crowded = max(0.0, 1.0 - gap / ROOM_M)
            free.append(FreeSpot(place, wish(place) + ROOM_COST * crowded * 0.2))
    free.sort(key=lambda spot: (spot.cost, *spot.place_m.tolist()))
    return free


def _chosen(free: Iterable[FreeSpot], known: Callable[[Array], bool]) -> list[FreeSpot]:
    """The first ones about which everything is known, some way apart."""
    chosen: list[FreeSpot] = []
    for spot in free:
        apart = all(math.dist(spot.place_m, other.place_m) >= APART_M for other in chosen)
        if apart and known(spot.place_m):
            chosen.append(spot)
        if len(chosen) == MOST:
            break
    return chosen


def _gaps_m(places: list[Array], around: list[SceneObject], radius_m: float) -> list[float]:
    """From each place's foot to that of its nearest neighbour."""
    if not places or not around:
        return [ROOM_M] * len(places)
    at = np.array(places)[:, :2]
    gaps: list[float] = (np.min([_away_m(item, at) for item in around], axis=0) - radius_m).tolist()
    return gaps


def _away_m(item: SceneObject, points: Array) -> Array:
    """Distance of points, shape (n, 2), from an object's foot.

    Furniture counts with its sides: a circle around a wall or the back of a shelf would take all the room
    before it. How things that hands move are turned is seen less surely, and they are small.
    """
    ways = points - item.world_T_object[:2, 3]
    upright = item.world_T_object[2, 2] > _UPRIGHT
    if item.movable or not upright or not isinstance(item.shape, Box):
        return np.asarray(np.hypot(ways[:, 0], ways[:, 1]) - footprint_radius_m(item.shape))
    beyond = np.abs(ways @ item.world_T_object[:2, :2]) - 0.5 * np.array(item.shape.size_m[:2])
    return np.asarray(np.linalg.norm(np.maximum(beyond, 0.0), axis=1))


def _stands_at(item: SceneObject, height_m: float) -> bool:
    """Whether an object reaches above a height and begins near or below it."""
    middle, half = float(item.world_T_object[2, 3]), 0.5 * _extent_m(item)
    return middle + half > height_m + 0.005 and middle - half < height_m + _ON_TOP_M


def _extent_m(item: SceneObject) -> float:
    return (
        max(item.shape.height_m, 2.0 * footprint_radius_m(item.shape))
        if item.movable
        else item.shape.height_m
    )
