"""One solid put here and there along a ray, beside a robot in many postures."""

from __future__ import annotations

import numpy as np
import pinocchio as pin

from kinematics.arrays import Array
from kinematics.model.robot_model import RobotModel
from tools.checking.solid_world import EnclosingBalls, SolidWorld


class Ray:
    """Answers whether the solid is near to the robot in any of its postures.

    What was measured at one place says something about all others: moved by a length, the solid comes no
    nearer to anything than by that length.

    Args:
        model: The robot.
        world: Pairs with the solid alone.
        name: Of the solid.
        origin: Where the ray begins, shape (3,).
        direction: Unit vector, shape (3,).
        rows: Postures, shape (n, nq).
    """

    def __init__(
        self, model: RobotModel, world: SolidWorld, name: str, origin: Array, direction: Array, rows: Array
    ) -> None:
        self._geometry, self._margins = world.geometry, world.margins
        self._own = world.solids_of(name)
        self._origin, self._direction = origin, direction
        self._turn = self._geometry.geometryObjects[self._own[0]].placement.rotation
        self._rows = [self._geometry.createData() for _ in rows]
        data = model.pin.createData()
        for placed, q in zip(self._rows, rows, strict=True):
            pin.updateGeometryPlacements(model.pin, data, self._geometry, placed, q)
        # the balls' centres of what does not move along the ray, by row and pair
        balls = EnclosingBalls(self._geometry)
        pairs = [(pair.first, pair.second) for pair in self._geometry.collisionPairs]
        other = [a if b in self._own else b for a, b in pairs]
        own = [b if b in self._own else a for a, b in pairs]
        # the centre of a part's ball is not the origin of the frame that all parts have
        aside = balls.local_m[own] @ self._turn.T
        self._centres = np.array([balls.centres_m(placed)[other] - aside for placed in self._rows])
        self._enough_m = balls.enough_m + self._margins
        shape = self._centres.shape[:2]
        self._known_m, self._known_at = np.full(shape, -np.inf), np.zeros(shape)

    def nearer_than(self, distance_m: float, gap_m: float) -> bool:
        """Tell whether the solid, so far along the ray, has this gap beyond its margin or less."""
        place = self._origin + distance_m * self._direction
        pose = pin.SE3(self._turn, place)
        for placed in self._rows:
            for index in self._own:
                placed.oMg[index] = pose
        by_balls = np.linalg.norm(self._centres - place, axis=2) - self._enough_m
        least = np.maximum(by_balls, self._known_m - np.abs(self._known_at - distance_m))
        candidates = np.argwhere(least <= gap_m)
        compute, geometry = pin.computeDistance, self._geometry
        for row, pair in candidates[np.argsort(least[tuple(candidates.T)])].tolist():
            gap = compute(geometry, self._rows[row], pair).min_distance - self._margins[pair]
            self._known_m[row, pair], self._known_at[row, pair] = gap, distance_m
            if gap <= gap_m:
                return True
        return False
