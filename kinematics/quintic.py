"""The quintic from rest to rest: the share of a way that has passed, and its rates."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

PEAK = 1.875
"""Its greatest speed over the mean."""


def rest_to_rest(u: Array, duration_s: float) -> tuple[Array, Array, Array]:
    """Share, its rate in 1/s and that one's rate in 1/s^2, at shares ``u`` of a duration; shapes as ``u``."""
    share = u**3 * (10.0 - 15.0 * u + 6.0 * u**2)
    rate = 30.0 * u**2 * (1.0 - u) ** 2 / duration_s
    slope = 60.0 * u * (1.0 - 3.0 * u + 2.0 * u**2) / duration_s**2
    return share, rate, slope
