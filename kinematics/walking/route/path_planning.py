"""Paths over the floor around what stands on it: A* on a grid, then corners cut where the way is free."""

from __future__ import annotations

import heapq
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Ball, Box
from kinematics.scene.planning_scene import PlanningScene
from kinematics.scene.support_of import top_m

_CELL_M = 0.05
_ROOM_ROUND_M = 1.5
"""The grid reaches this far beyond start, goal and obstacles."""
_TOWARDS = 1.0 + 1e-9
"""Of ways that are equally short, the one that is nearer to its end is followed first."""
_NEIGHBOURS = tuple((i, j, math.hypot(i, j)) for i in (-1, 0, 1) for j in (-1, 0, 1) if (i, j) != (0, 0))


@dataclass(frozen=True, slots=True)
class Footprint:
    """What something takes of the floor: a rectangle, and what is nearer to it than a radius.

    Attributes:
        pose: Middle and heading of the rectangle.
        half_x_m, half_y_m: Its half-sizes; 0 for what is round.
        radius_m: The radius; 0 for what is not.
    """

    pose: PlanarPose
    half_x_m: float
    half_y_m: float
    radius_m: float = 0.0

    def distance_m(self, points: Array) -> Array:
        """Distance of points on the floor, shape (n, 2), to it; 0 inside."""
        c, s = math.cos(self.pose.yaw_rad), math.sin(self.pose.yaw_rad)
        dx, dy = points[:, 0] - self.pose.x_m, points[:, 1] - self.pose.y_m
        out_x = np.maximum(np.abs(c * dx + s * dy) - self.half_x_m, 0.0)
        out_y = np.maximum(np.abs(c * dy - s * dx) - self.half_y_m, 0.0)
        return np.asarray(np.maximum(np.hypot(out_x, out_y) - self.radius_m, 0.0))


def footprints(
    scene: PlanningScene, wider: Sequence[tuple[float, float]] = (), above_m: float = -math.inf
) -> tuple[Footprint, ...]:
    """Those of everything in a scene that does not hang on a hand.

    Args:
        scene: What is believed.
        wider: Pairs of a height and the room that what reaches above it takes besides, all around, m; the
            most of what applies.
        above_m: Only things that reach above this height.
    """
    found = []
    for item in scene.objects.values():
        top = top_m(item)
        if top < above_m:
            continue
        more_m = max((room_m for from_m, room_m in wider if top >= from_m), default=0.0)
        pose = PlanarPose.of(item.world_T_object)
        if isinstance(item.shape, Box):
            found.append(Footprint(pose, 0.5 * item.shape.size_m[0], 0.5 * item.shape.size_m[1], more_m))
        else:
            reach_m = (
                item.shape.radius_m
                if isinstance(item.shape, Ball)
                else _round_m(item.world_T_object, item.shape)
            )
            found.append(Footprint(pose, 0.0, 0.0, reach_m + more_m))
    return tuple(found)


def clearance_m(obstacles: Iterable[Footprint], point: PlanarPose) -> float:
    """Distance of a point to the nearest obstacle; infinite if there is none."""
    at = np.array([[point.x_m, point.y_m]])
    return min((float(obstacle.distance_m(at)[0]) for obstacle in obstacles), default=math.inf)


def plan_path(
    start: PlanarPose,
    goal: PlanarPose,
    obstacles: Sequence[Footprint],
    clearance: float,
    points: Array | None = None,
    points_m: float = 0.0,
) -> tuple[PlanarPose, ...] | None:
    """The shortest way that keeps a distance from all obstacles, or None.

    Where the start or the goal is nearer to something than that, the distance grows up to it from there.

    Args:
        start, goal: Its ends.
        obstacles: What is known to stand on the floor.
        clearance: The distance, m.
        points: Further places where something is, shape (n, 2).
        points_m: Room that each of them takes all around.
    """
    points = np.zeros((0, 2)) if points is None else points
    nearest = [
        min(clearance_m(obstacles, end), float(_apart(points, end).min(initial=math.inf)) - points_m)
        for end in (start, goal)
    ]
    least = min(clearance, *(near - _CELL_M for near in nearest))
    places = [(p.pose.x_m, p.pose.y_m) for p in obstacles]
    around = np.array([(start.x_m, start.y_m), (goal.x_m, goal.y_m), *places, *points])
    low, high = around.min(axis=0) - _ROOM_ROUND_M, around.max(axis=0) + _ROOM_ROUND_M
    size = np.ceil((high - low) / _CELL_M).astype(int) + 1
    xs, ys = low[0] + _CELL_M * np.arange(size[0]), low[1] + _CELL_M * np.arange(size[1])
    cells = np.stack(np.meshgrid(xs, ys, indexing="ij"), axis=-1).reshape(-1, 2)
    distance = np.full(len(cells), np.inf)
    for obstacle in obstacles:
        distance = np.minimum(distance, obstacle.distance_m(cells))
    distance = np.minimum(distance, _distance_to(points, xs, ys, clearance + points_m).ravel() - points_m)
    from_ends = np.minimum(
        np.hypot(cells[:, 0] - start.x_m, cells[:, 1] - start.y_m),
        np.hypot(cells[:, 0] - goal.x_m, cells[:, 1] - goal.y_m),
    )
    needed = np.minimum(clearance, max(least, 0.0) + from_ends)
    free = (distance > needed).reshape(size[0], size[1])
    first, last = _cell(start, low), _cell(goal, low)
    free[first] = free[last] = True
    way = _search(free, first, last)
    if way is None:
        return None
    corners = [start, *(PlanarPose(float(xs[i]), float(ys[j])) for i, j in way[1:-1]), goal]
    return tuple(_cut(corners, free, low))


def _apart(points: Array, end: PlanarPose) -> Array:
    return np.hypot(points[:, 0] - end.x_m, points[:, 1] - end.y_m)


def _distance_to(points: Array, xs: Array, ys: Array, within_m: float) -> Array:
    """Distance of each cell to the nearest of some points, as far as it is small, shape of the grid."""
    found = np.full((len(xs), len(ys)), np.inf)
    reach = math.ceil(within_m / _CELL_M) + 1
    for x, y in points:
        i, j = round((x - xs[0]) / _CELL_M), round((y - ys[0]) / _CELL_M)
        rows, columns = slice(max(i - reach, 0), i + reach + 1), slice(max(j - reach, 0), j + reach + 1)
        away = np.hypot(xs[rows, None] - x, ys[None, columns] - y)
        found[rows, columns] = np.minimum(found[rows, columns], away)
    return found


def _cell(point: PlanarPose, low: Array) -> tuple[int, int]:
    return round((point.x_m - float(low[0])) / _CELL_M), round((point.y_m - float(low[1])) / _CELL_M)


def _search(
    free: NDArray[np.bool_], first: tuple[int, int], last: tuple[int, int]
) -> list[tuple[int, int]] | None:
    """A* in plain numbers, with a border that is not free: an array of cells is asked ten times as slowly."""
    rows, columns = free.shape
    stride = columns + 2
    bordered = np.zeros((rows + 2, stride), dtype=np.bool_)
    bordered[1:-1, 1:-1] = free
    is_open, begin, end = (
        bytearray(bordered.tobytes()),
        *((cell[0] + 1) * stride + cell[1] + 1 for cell in (first, last)),
    )
    to_go = _octile(bordered.shape, (last[0] + 1, last[1] + 1)).ravel().tolist()
    steps = [(i * stride + j, length) for i, j, length in _NEIGHBOURS]
    cost = [math.inf] * len(is_open)
    came = [begin] * len(is_open)
    cost[begin] = 0.0
    queue = [(to_go[begin], begin)]
    while queue:
        _, here = heapq.heappop(queue)
        if here == end:
            way = [here]
            while way[-1] != begin:
                way.append(came[way[-1]])
            return [(cell // stride - 1, cell % stride - 1) for cell in reversed(way)]
        if not is_open[here]:
            continue
        is_open[here] = 0
        so_far = cost[here]
        for step, length in steps:
            there = here + step
            new = so_far + length
            if is_open[there] and new < cost[there]:
                cost[there], came[there] = new, here
                heapq.heappush(queue, (new + to_go[there], there))
    return None


def _octile(shape: tuple[int, ...], last: tuple[int, int]) -> Array:
    """The least that is left to go from each cell, in cells, straight and across."""
    di, dj = (np.abs(np.arange(size) - at) for size, at in zip(shape, last, strict=True))
    longer, shorter = np.maximum.outer(di, dj), np.minimum.outer(di, dj)
    return np.asarray(_TOWARDS * (longer + (math.sqrt(2.0) - 1.0) * shorter), dtype=np.float64)


def blocked(path: Sequence[PlanarPose], points: Array, within_m: float) -> bool:
    """Whether one of some points, shape (n, 2), is nearer to a path than a distance."""
    for a, b in pairwise(path):
        dx, dy = b.x_m - a.x_m, b.y_m - a.y_m
        length = max(dx * dx + dy * dy, 1e-12)
        share = np.clip(((points[:, 0] - a.x_m) * dx + (points[:, 1] - a.y_m) * dy) / length, 0.0, 1.0)
        away = np.hypot(points[:, 0] - a.x_m - share * dx, points[:, 1] - a.y_m - share * dy)
        if bool((away < within_m).any()):
            return True
    return False


def _cut(points: list[PlanarPose], free: NDArray[np.bool_], low: Array) -> list[PlanarPose]:
    """Leave out corners where the straight line is free."""
    kept, k = [points[0]], 0
    while k < len(points) - 1:
        reach = next(
            (j for j in range(len(points) - 1, k + 1, -1) if _line_free(points[k], points[j], free, low)),
            k + 1,
        )
        kept.append(points[reach])
        k = reach
    return kept


def _line_free(a: PlanarPose, b: PlanarPose, free: NDArray[np.bool_], low: Array) -> bool:
    count = max(2, math.ceil(2.0 * a.distance_m(b) / _CELL_M))
    share = np.linspace(0.0, 1.0, count)
    i = np.rint((a.x_m + share * (b.x_m - a.x_m) - low[0]) / _CELL_M).astype(int)
    j = np.rint((a.y_m + share * (b.y_m - a.y_m) - low[1]) / _CELL_M).astype(int)
    return bool(free[i, j].all())


def _round_m(world_T_object: Array, shape: object) -> float:
    """Reach of a cylinder, standing or lying."""
    radius_m, height_m = getattr(shape, "radius_m", 0.0), getattr(shape, "height_m", 0.0)
    upright = abs(float(world_T_object[2, 2]))
    return float(radius_m + 0.5 * height_m * math.sqrt(max(0.0, 1.0 - upright * upright)))
