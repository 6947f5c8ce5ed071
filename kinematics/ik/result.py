"""An answer of inverse kinematics, and how exact it has to be."""

from __future__ import annotations

import math
from dataclasses import dataclass

from kinematics.arrays import Array, Sealed
from kinematics.geometry.poses import Transform


@dataclass(frozen=True, slots=True)
class IkTolerance:
    """Residuals that an answer may have."""

    position_m: float = 5e-4
    orientation_rad: float = 3e-3
    com_margin_m: float = 0.0


@dataclass(frozen=True, slots=True)
class IkResult(Sealed):
    """One inverse-kinematics answer, with the evidence to judge it by.

    Attributes:
        q: Configuration, shape (nq,), Pinocchio order; the soles are at the stance exactly.
        position_error_m: Distance of the TCP from its target.
        orientation_error_rad: Angle between TCP and target.
        com_margin_m: Distance of the CoM's ground projection to the edge of the support polygon,
            positive inside; infinite when the base is welded.
        limits_kept: Whether every joint is inside its limits (shrunk for planning).
        feet_reached: Whether the legs can be placed.
        iterations: Steps of the solver.
    """

    q: Array
    position_error_m: float
    orientation_error_rad: float
    com_margin_m: float
    limits_kept: bool
    feet_reached: bool
    iterations: int

    def within(self, tolerance: IkTolerance) -> bool:
        """Tell whether every residual is inside ``tolerance``."""
        return (
            self.feet_reached
            and self.limits_kept
            and self.position_error_m <= tolerance.position_m
            and self.orientation_error_rad <= tolerance.orientation_rad
            and self.com_margin_m >= tolerance.com_margin_m
        )


# With a CoM margin of 30 mm on paper, TALOS was seen to tip over slowly.
DEFAULT_TOLERANCE = IkTolerance(com_margin_m=0.05)


def errors_between(actual: Transform, wanted: Transform) -> tuple[float, float]:
    """Distance, m, and angle, rad, between two poses."""
    distance = math.dist(actual[:3, 3].tolist(), wanted[:3, 3].tolist())
    trace = float((actual[:3, :3] * wanted[:3, :3]).sum())
    return distance, math.acos(min(1.0, max(-1.0, (trace - 1.0) / 2.0)))
