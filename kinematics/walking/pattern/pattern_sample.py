"""One instant of a walk's plan."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum

from kinematics.geometry.planar import PlanarPose
from kinematics.model.robot_description import Hand
from kinematics.walking.pattern.com_motion import ComSample


class Phase(Enum):
    """What the feet do."""

    SHIFT = "shift"
    SWING = "swing"
    LAND = "land"
    CLOSE = "close"
    SETTLE = "settle"
    REST = "rest"


@dataclass(frozen=True, slots=True)
class PatternSample:
    """One instant, in the plan's frame.

    Attributes:
        com: CoM, DCM and ZMP.
        feet: Each sole's place.
        lift_m: Height of each sole.
        carrying: The feet that carry.
        phase: What they do.
    """

    com: ComSample
    feet: Mapping[Hand, PlanarPose]
    lift_m: Mapping[Hand, float]
    carrying: tuple[Hand, ...]
    phase: Phase
