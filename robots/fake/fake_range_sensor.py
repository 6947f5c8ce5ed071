"""A range sensor on an open floor, which sees what it is told to."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


class FakeRangeSensor:
    """Satisfies ``RangeSensor``.

    Attributes:
        points_m: What is around, from the body, shape (n, 3).
        silent: While true, there are no scans.
    """

    def __init__(self) -> None:
        """Nothing is around."""
        self.points_m: NDArray[np.float64] = np.zeros((0, 3))
        self.silent = False

    def scan(self) -> NDArray[np.float64] | None:
        """The points, or None while it is silent."""
        return None if self.silent else self.points_m.copy()
