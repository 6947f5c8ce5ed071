"""How wrong the place and size of a detection may be, as its detector declares."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from kinematics.arrays import Array, Sealed


@dataclass(frozen=True, slots=True)
class PositionError(Sealed):
    """Covariances of a detection's position, and the standard deviation of its size.

    Attributes:
        lasting_m2: Of what stays from frame to frame (calibration, the recogniser's bias), in the frame in
            which the position is told, shape (3, 3).
        noise_m2: Of what is drawn anew in each frame, shape (3, 3).
        size_share: Standard deviation of sizes, as a share of them; it lasts too.
    """

    lasting_m2: Array
    noise_m2: Array
    size_share: float

    @property
    def is_noisy(self) -> bool:
        """Whether two frames never tell exactly the same."""
        return bool(np.trace(self.noise_m2) > 0.0)

    def turned(self, rotation: Array) -> PositionError:
        """The same in another frame.

        Args:
            rotation: Maps the present frame's coordinates into the other's, shape (3, 3).
        """
        return PositionError(
            rotation @ self.lasting_m2 @ rotation.T, rotation @ self.noise_m2 @ rotation.T, self.size_share
        )

    def averaged(self, frames: int) -> PositionError:
        """Of the mean of some frames: noise averages away, what lasts does not."""
        return PositionError(self.lasting_m2, self.noise_m2 / frames, self.size_share)

    @property
    def covariance_m2(self) -> Array:
        """Of both together, shape (3, 3)."""
        return np.asarray(self.lasting_m2 + self.noise_m2)


@lru_cache(maxsize=64)
def alike_in_all_directions(lasting_m: float, noise_m: float, size_share: float) -> PositionError:
    """An error with the same standard deviations along every axis, m."""
    return PositionError(lasting_m**2 * np.eye(3), noise_m**2 * np.eye(3), size_share)
