"""A steering that also says where the head looks while the body walks."""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.geometry.planar import PlanarPose
from kinematics.walking.pattern.steering import Steering


@dataclass(frozen=True, slots=True)
class Gazing:
    """Go where another steering says, and look somewhere meanwhile.

    Without it the head stays as it was when the walk began.

    Attributes:
        steering: Decides the steps.
        pan_rad: Of the head, to the left.
        tilt_rad: Of the head, down.
    """

    steering: Steering
    pan_rad: float
    tilt_rad: float

    def advance(self, body: PlanarPose, before: PlanarPose) -> PlanarPose | None:
        """The step of the other steering."""
        return self.steering.advance(body, before)
