"""How wrong the place and size of a detection may be, as its detector declares."""

from __future__ import annotations

from dataclasses import dataclass, field
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
        shared_m2: The part of what lasts that everything has in common that one camera shows in one place
            (its calibration), shape (3, 3). Between two things of one camera it is no difference.
    """

    lasting_m2: Array
    noise_m2: Array
    size_share: float
    shared_m2: Array = field(default_factory=lambda: np.zeros((3, 3)))

    @property
    def is_noisy(self) -> bool:
        """Whether two frames never tell exactly the same."""
        return bool(np.trace(self.noise_m2) > 0.0)

    def turned(self, rotation: Array) -> PositionError:
        """The same in another frame.

        Args:
            rotation: Maps the present frame's coordinates into the other's, shape (3, 3).
        """
        lasting, noise, shared = (
            rotation @ part @ rotation.T for part in (self.lasting_m2, self.noise_m2, self.shared_m2)
        )
        return PositionError(lasting, noise, self.size_share, shared)

    def averaged(self, frames: int) -> PositionError:
        """Of the mean of some frames: noise averages away, what lasts does not."""
        return PositionError(self.lasting_m2, self.noise_m2 / frames, self.size_share, self.shared_m2)

    @property
    def covariance_m2(self) -> Array:
        """Of both together, shape (3, 3)."""
        return np.asarray(self.lasting_m2 + self.noise_m2)

    @property
    def own_m2(self) -> Array:
        """Of what the thing has for itself, beside others that the same camera shows, shape (3, 3)."""
        return np.asarray(self.covariance_m2 - self.shared_m2)


@lru_cache(maxsize=64)
def alike_in_all_directions(
    lasting_m: float, noise_m: float, size_share: float, shared_m: float = 0.0
) -> PositionError:
    """An error with the same standard deviations along every axis, m.

    Args:
        lasting_m: Of what stays from frame to frame and is each thing's own.
        noise_m: Of what is drawn anew in each frame.
        size_share: Of sizes, as a share of them.
        shared_m: Of what stays and all things have in common.
    """
    shared = shared_m**2 * np.eye(3)
    return PositionError(lasting_m**2 * np.eye(3) + shared, noise_m**2 * np.eye(3), size_share, shared)
