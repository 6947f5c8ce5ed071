"""Where somebody stands on the floor."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Standing:
    """Where a person is: place on the floor in the world frame, m, and heading, rad."""

    x_m: float
    y_m: float
    yaw_rad: float
