"""Find a collision-free path between two configurations of a standing robot.

The straight line when it is free, RRT-Connect else (Kuffner and LaValle, ICRA 2000), then shortcuts:
compiled where the robot has the kernel for its judge, in Python where not.
Planned over the free coordinates, so the feet stay where they are; counted in iterations and drawn
from an injected generator, so the same seed gives the same path.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array
from kinematics.collision.leg_room import leg_room
from kinematics.collision.validity import RESOLUTION, Validity
from kinematics.model.robot_model import RobotModel
from kinematics.motion.curves import Curve, PolynomialCurve, RoundedPolyline
from kinematics.standing.free_coordinates import FreeCoordinates
from kinematics.standing.reserves import LEAST_RESERVE_M

# The longest step of a tree; the compiled search takes longer ones, whose free parts it proves at once.
EXTEND = 0.5
COMPILED_EXTEND = 1.0
# The pelvis may leave the box between start and goal by so much, m and rad.
PELVIS_ROOM = np.array([0.04, 0.03, 0.06, 0.05, 0.05, 0.05])
# Distances of the control points that round a polyline's corners, tried in turn.
ROUNDINGS = (0.12, 0.03, 0.0075)
# Points of a curve at which the legs are looked at.
LEG_LOOKS = 9
# A pelvis that is nearer to home than this in every coordinate, m and rad, has the legs apart: TALOS loses
# 1.2 of 11.9 mm there.
LEGS_AS_AT_HOME = 0.05
# Directions that differ by less than this are one.
_STRAIGHT = 1e-9


@dataclass(frozen=True, slots=True)
class PathSettings:
    """How long a search for a path goes on.

    Attributes:
        iterations: Most extensions of the two trees.
        shortcuts: Attempts to cut a found path short.
    """

    iterations: int = 300
    shortcuts: int = 40


class PathPlanner:
    """Plans between points of a robot's free coordinates.

    Attributes:
        judge: Tells what is free.
    """

    def __init__(
        self,
        model: RobotModel,
        space: FreeCoordinates,
        judge: Validity,
        settings: PathSettings = PathSettings(),
    ) -> None:
        self._space, self.judge, self._settings = space, judge, settings
        self._model = model
        self._legs = leg_room(model)
        margin = model.description.planning_margin_rad
        self._lower, self._upper = model.lower_rad + margin, model.upper_rad - margin

    def plan(self, start: Array, goal: Array, moving: list[int], rng: np.random.Generator) -> Curve | None:
        """Return a collision-free curve from ``start`` to ``goal``, or None when none was found.

        Args:
            start: Free coordinates, shape (size,).
            goal: The same.
            moving: Columns that may leave the straight line between start and goal.
            rng: Source of the samples.
        """
        line = self.straight(start, goal)
        if line is not None:
            return line
        polyline = self._polyline(start, goal, moving, rng)
        if polyline is None:
            return None
        # where rounding touches something, finer control points stay nearer to the free polyline
        for spacing in ROUNDINGS:
            curve = RoundedPolyline(polyline, self._space.weights, spacing)
            if self._bends_are_free(curve) and self._legs_stay_apart(curve, from_start=True):
                return curve
        return None

    def _bends_are_free(self, curve: RoundedPolyline) -> bool:
        """Check what is off the polyline, which is free itself."""
        return all(self.judge.polyline_is_free(points) for points in curve.bends())

    def straight(self, start: Array, goal: Array) -> Curve | None:
        """The straight line between two points, or None when it is not free."""
        ends = np.stack([start, goal])
        if not self.judge.polyline_is_free(ends):
            return None
        curve = PolynomialCurve(ends)
        return curve if self._legs_stay_apart(curve, from_start=True) else None

    def curve_is_free(self, curve: Curve) -> bool:
        """Check a curve along lines no longer than the resolution, and three at least between its knots."""
        return self._keeps_distances(curve) and self._legs_stay_apart(curve)

    def _keeps_distances(self, curve: Curve) -> bool:
        grid = curve(np.linspace(0.0, 1.0, 65))
        length = float(np.sum(np.sqrt(np.sum((np.diff(grid, axis=0) * self._space.weights) ** 2, axis=1))))
        count = max(int(np.ceil(length / RESOLUTION)), 3 * (len(curve.knots) - 1)) + 1
        return self.judge.polyline_is_free(_without_needless(curve(np.linspace(0.0, 1.0, count))))

    def is_free(self, x: Array) -> bool:
        """Check one point: reach of the legs, limits, balance, collision."""
        return self.judge.points_are_free(x[None, :])

    def _legs_stay_apart(self, curve: Curve, from_start: bool = False) -> bool:
        """Look at the legs along a curve; where the robot stands already, they need not be farther apart."""
        base = self._space.base_size
        if self._legs is None:
            return True
        x = curve(np.linspace(0.0, 1.0, LEG_LOOKS))
        if np.abs(x[:, :base] - self._space.home[:base]).max() < LEGS_AS_AT_HOME:
            return True
        q = self._space.to_q(x)[0]
        if not self._legs.too_near(q).any():
            return True
        clearances_m = self._legs.clearances_m(q)
        return from_start and bool(clearances_m.min() >= min(LEAST_RESERVE_M, float(clearances_m[0])))

    def _edge_is_free(self, a: Array, b: Array) -> bool:
        return self.judge.polyline_is_free(np.stack([a, b]))

    def _polyline(
        self, start: Array, goal: Array, moving: list[int], rng: np.random.Generator
    ) -> Array | None:
        search, settings = self.judge.path_search(), self._settings
        if search is None:
            polyline = self._rrt_connect(start, goal, moving, rng)
            return None if polyline is None else self._shortened(polyline, rng)
        seed, weights = int(rng.integers(2**53)), self._space.weights
        lower, upper = self._sampling_box(start, goal, moving)
        found = search.connect(start, goal, lower, upper, weights, COMPILED_EXTEND, settings.iterations, seed)
        return None if found is None else search.shorten(found, weights, settings.shortcuts)

    def _rrt_connect(
        self, start: Array, goal: Array, moving: list[int], rng: np.random.Generator
    ) -> Array | None:
        if not self.is_free(start) or not self.is_free(goal):
            return None
        lower, upper = self._sampling_box(start, goal, moving)
        trees = [_Tree(start), _Tree(goal)]
        for iteration in range(self._settings.iterations):
            grown, other = trees[iteration % 2], trees[1 - iteration % 2]
            sample = rng.uniform(lower, upper)
            new = self._extend(grown, sample)
            if new is None:
                continue
            joined = self._connect(other, grown.points[new])
            if joined is not None:
                first, second = grown.path_to(new), other.path_to(joined)
                path = np.array(first + second[::-1])
                return path if grown is trees[0] else path[::-1]
        return None

    def _sampling_box(self, start: Array, goal: Array, moving: list[int]) -> tuple[Array, Array]:
        lower, upper = np.minimum(start, goal), np.maximum(start, goal)
        base = self._space.base_size
        lower[:base] -= PELVIS_ROOM[:base]
        upper[:base] += PELVIS_ROOM[:base]
        for column in moving:
            index = self._model.joint_index(self._space.joints[column - base])
            lower[column], upper[column] = self._lower[index], self._upper[index]
        return lower, upper

    def _extend(self, tree: _Tree, sample: Array) -> int | None:
        near = tree.nearest(sample, self._space.weights)
        distance = self._space.distance(tree.points[near], sample)
        if distance < 1e-9:
            return None
        point = tree.points[near] + (sample - tree.points[near]) * min(1.0, EXTEND / distance)
        return tree.add(point, near) if self._edge_is_free(tree.points[near], point) else None

    def _connect(self, tree: _Tree, point: Array) -> int | None:
        node = tree.nearest(point, self._space.weights)
        while True:
            distance = self._space.distance(tree.points[node], point)
            here = tree.points[node]
            step = point if distance <= EXTEND else here + (point - here) * (EXTEND / distance)
            if not self._edge_is_free(here, step):
                return None
            node = tree.add(step, node)
            if distance <= EXTEND:
                return node

    def _shortened(self, polyline: Array, rng: np.random.Generator) -> Array:
        for _ in range(self._settings.shortcuts):
            if len(polyline) <= 2:
                break
            i, j = sorted(rng.choice(len(polyline), 2, replace=False))
            if j - i < 2:
                continue
            if self._edge_is_free(polyline[i], polyline[j]):
                polyline = np.concatenate([polyline[: i + 1], polyline[j:]])
        return polyline


def _without_needless(points: Array) -> Array:
    """Points of a polyline, shape (n, size), without those in the middle of straight parts."""
    steps = np.diff(points, axis=0)
    steps = steps / np.maximum(np.sqrt(np.sum(steps**2, axis=1)), 1e-12)[:, None]
    bent = np.max(np.abs(np.diff(steps, axis=0)), axis=1) > _STRAIGHT
    return np.asarray(points[np.concatenate([[True], bent, [True]])])


class _Tree:
    def __init__(self, root: Array) -> None:
        self.points = root[None, :].copy()
        self._parents = [-1]

    def add(self, point: Array, parent: int) -> int:
        self.points = np.concatenate([self.points, point[None, :]])
        self._parents.append(parent)
        return len(self._parents) - 1

    def nearest(self, point: Array, weights: Array) -> int:
        return int(np.argmin(np.sum(((self.points - point) * weights) ** 2, axis=1)))

    def path_to(self, node: int) -> list[Array]:
        path = []
        while node >= 0:
            path.append(self.points[node])
            node = self._parents[node]
        return path[::-1]
