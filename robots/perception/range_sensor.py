"""What tells how far away things are, whatever they are."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray


class RangeSensor(Protocol):
    """Looks around at several heights."""

    def scan(self) -> NDArray[np.float64] | None:
        """Points on what is around, in a level frame at the base, x ahead, z up from the floor, (n, 3).

        None while the sensor has nothing to say: before the first scan, or after a silence.
        """
        ...
