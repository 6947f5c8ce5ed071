"""How well a standing robot's hands reach the places around it: a map that is made once for a robot.

The idea of a map of shares of directions is Zacharias, Borst and Hirzinger's, "Capturing robot workspace
structure", IROS 2007; ``tools.robot_data.reachability_map`` makes it with whole-body inverse kinematics.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

from kinematics.geometry.planar import PlanarPose

Cells = tuple[tuple[tuple[float, ...], ...], ...]
"""Shares by height, ahead and aside."""


@dataclass(frozen=True, slots=True)
class GridAxis:
    """Evenly spaced values, m: the first one, what is between two, and how many."""

    first_m: float
    step_m: float
    count: int

    def values_m(self) -> Iterator[float]:
        """All of them."""
        return (self.first_m + self.step_m * k for k in range(self.count))

    def between(self, value_m: float) -> tuple[int, float] | None:
        """The value below and the share of the way to the next one; None outside."""
        at = (value_m - self.first_m) / self.step_m
        if not -1e-9 <= at <= self.count - 1 + 1e-9:
            return None
        below = min(max(math.floor(at), 0), self.count - 2)
        return below, min(max(at - below, 0.0), 1.0)


@dataclass(frozen=True, slots=True)
class ReachabilityMap:
    """How well each hand reaches the places around a robot: at each, the share of the directions of grasp in
    which the hand gets there.

    Places are seen from the middle between the feet, on the floor: x ahead, y to the left, z up, m.

    Attributes:
        ahead, aside, height: The grid's axes, at least two values each.
        shares: By hand, 0 to 1, shape (height.count, ahead.count, aside.count).
    """

    ahead: GridAxis
    aside: GridAxis
    height: GridAxis
    shares: Mapping[str, Cells]

    def share(self, hand: str, x_m: float, y_m: float, z_m: float) -> float:
        """Share at a place, linear between those of the grid.

        Outside the grid nothing is reached; above and below it, what is at its end.
        """
        top_m = self.height.first_m + self.height.step_m * (self.height.count - 1)
        x, y = self.ahead.between(x_m), self.aside.between(y_m)
        z = self.height.between(min(max(z_m, self.height.first_m), top_m))
        cells = self.shares.get(hand)
        if x is None or y is None or z is None or cells is None:
            return 0.0
        total = 0.0
        for k, of_k in ((z[0], 1.0 - z[1]), (z[0] + 1, z[1])):
            for i, of_i in ((x[0], 1.0 - x[1]), (x[0] + 1, x[1])):
                for j, of_j in ((y[0], 1.0 - y[1]), (y[0] + 1, y[1])):
                    total += of_k * of_i * of_j * cells[k][i][j]
        return total

    def share_from(self, body: PlanarPose, hand: str, thing_m: tuple[float, float, float]) -> float:
        """Share of a place in the world for a body that stands somewhere.

        Args:
            body: The middle between the feet and its heading.
            hand: The hand.
            thing_m: The place; heights count from the floor.
        """
        return self.share(hand, *body.sees(thing_m[0], thing_m[1]), thing_m[2])

    def best_from(self, body: PlanarPose, hands: Iterable[str], thing_m: tuple[float, float, float]) -> float:
        """Share of that one of some hands which gets there best; 0 without any."""
        return max((self.share_from(body, hand, thing_m) for hand in hands), default=0.0)
