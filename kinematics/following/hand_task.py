"""What a jogged hand is asked for at one instant, as least squares of joint rates."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, Sealed
from kinematics.following.boxed_least_squares import boxed_least_squares


@dataclass(frozen=True, slots=True)
class HandTask(Sealed):
    """A velocity of a TCP, and what else the rates are to do.

    Rows weigh metres and radians alike; what they are worth is said by who makes the task.

    Attributes:
        joints: Which of the jogged joints may move, shape (n,).
        rows: What each rate gives of the velocity, shape (6, n).
        asked: The velocity asked for, shape (6,).
        normal: Of the least squares, shape (n, n).
        right: Their right side, shape (n,).
    """

    joints: NDArray[np.intp]
    rows: Array
    asked: Array
    normal: Array
    right: Array

    def solved(self, low: Array, high: Array) -> Array:
        """The best rates within bounds, rad/s, each shape (n,)."""
        return boxed_least_squares(self.normal, self.right, low, high)

    def share_of(self, rates: Array) -> float:
        """The share of the velocity asked for that rates, shape (n,), give; 1 where none is asked for."""
        size = float(self.asked @ self.asked)
        return float(self.asked @ (self.rows @ rates)) / size if size > 0.0 else 1.0
