"""What a gripper's own sensors tell about what it holds."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from kinematics.model.robot_description import GripperDescription, Hand
from robots.interface.hardware import GripSettings


@dataclass(frozen=True, slots=True)
class GripperReading:
    """Opening and effort of one gripper, from its encoder and motor current.

    Attributes:
        hand: Which hand.
        position_rad: Joint position.
        opening_m: Distance between the pads.
        effort_nm: Measured effort, positive when it presses inwards.
        holding: Whether opening and effort both say that something is between the pads.
        slides: Whether the joint slides, and efforts are newtons.
    """

    hand: Hand
    position_rad: float
    opening_m: float
    effort_nm: float
    holding: bool
    slides: bool = False

    @property
    def felt(self) -> dict[str, float]:
        """Opening and effort, by names that tell their units."""
        return {"opening_m": self.opening_m, **self.effort}

    @property
    def effort(self) -> dict[str, float]:
        """The effort, by a name that tells its unit."""
        return {"effort_n" if self.slides else "effort_nm": self.effort_nm}

    def __str__(self) -> str:
        unit = "N" if self.slides else "Nm"
        return f"{self.opening_m * 1000:.0f} mm, {self.effort_nm:.1f} {unit}"


def read_gripper(
    gripper: GripperDescription, grip: GripSettings, position_rad: float, effort_nm: float
) -> GripperReading:
    """Interpret a joint position and the effort of the joint (negative closes)."""
    angles, openings = zip(*gripper.opening_table, strict=True)
    pressing = -effort_nm if gripper.closed_rad < gripper.open_rad else effort_nm
    closed_beyond = (
        position_rad <= grip.empty_below_rad
        if gripper.closed_rad < gripper.open_rad
        else position_rad >= grip.empty_below_rad
    )
    return GripperReading(
        hand=gripper.hand,
        position_rad=position_rad,
        opening_m=float(np.interp(position_rad, angles, openings)),
        effort_nm=pressing,
        holding=not closed_beyond and pressing >= grip.held_effort_nm,
        slides=gripper.slides,
    )
