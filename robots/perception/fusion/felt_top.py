"""The height of a top, as a hand feels it that puts something down there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from robots.perception.fusion.gaussian import Gaussian, Innovation, Measurement

TOUCH_M = 0.002
"""Standard deviation of the height of a touch: encoders, a body that sways, and how far a hand still goes
down until the force is felt."""


@dataclass(frozen=True, slots=True)
class FeltTop:
    """One touch.

    Attributes:
        source: Which hand, for people: "right hand".
        stamp_s: When.
        height_m: Of the foot of what the hand held, at the touch.
        sigma_m: Standard deviation of that as the height of the top.
        contradicts: Whether the camera has shown the top at another height than both may be wrong by.
    """

    source: str
    stamp_s: float
    height_m: float
    sigma_m: float = TOUCH_M
    contradicts: bool = False

    def compared(self, seen_m: float, variance_m2: float) -> Innovation:
        """By how much the hand feels the top above where it is seen.

        Args:
            seen_m: Its height, as seen.
            variance_m2: Of that, less what it has in common with the foot of what the hand held: the same
                camera has shown both.
        """
        return _top(seen_m, variance_m2).innovation(self._measured)

    def fused(self, seen_m: float, variance_m2: float) -> float:
        """The height that hand and camera agree on, by what each may be wrong by."""
        return float(_top(seen_m, variance_m2).updated(self._measured).mean[0])

    @property
    def _measured(self) -> Measurement:
        return Measurement(
            self.source, self.stamp_s, np.array([self.height_m]), np.array([[self.sigma_m**2]]), np.eye(1)
        )


def _top(height_m: float, variance_m2: float) -> Gaussian:
    return Gaussian(np.array([height_m]), np.array([[variance_m2]]))
