"""The simulator's truth, as a camera sees it that does not move with the robot."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Sealed
from kinematics.geometry.poses import Transform
from robots.perception.truth_view import TrueObject
from robots.simulated.truth.truth import SimulatorTruth


@dataclass(frozen=True, slots=True)
class SeenFrom(Sealed):
    """A ``TruthView`` from another place than the robot's head.

    Attributes:
        truth: All of it.
        eye: ``world_T_camera`` of that place, shape (4, 4).
    """

    truth: SimulatorTruth
    eye: Transform

    def solids(self) -> tuple[TrueObject, ...]:
        """Everything that could be seen, in a fixed order."""
        return self.truth.solids()

    def world_T_camera(self) -> Transform:
        """Pose of the camera's optical frame, shape (4, 4)."""
        return self.eye

    def visible(self, name: str, points: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Which world points, shape (n, 3), on a solid are in sight of the camera, shape (n,)."""
        return self.truth.visible_from(self.eye[:3, 3], name, points)
