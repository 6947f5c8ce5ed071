"""One instant of a walk's plan."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum

from kinematics.geometry.planar import PlanarPose
from kinematics.model.robot_description import Hand
from kinematics.walking.pattern.com_motion import ComSample


class Phase(Enum):
    """What the feet of a walking robot do at an instant."""

    SHIFT = "shift"
    SWING = "swing"
    LAND = "land"
    CLOSE = "close"
    SETTLE = "settle"
    REST = "rest"


@dataclass(frozen=True, slots=True)
class PatternSample:
    """A walk at one instant, in the plan's frame.

    Attributes:
        com: CoM, DCM and ZMP.
        feet: Place and heading of each sole.
        lift_m: Height of each sole.
        carrying: The feet that carry.
        phase: What the feet do.
    """

    com: ComSample
    feet: Mapping[Hand, PlanarPose]
    lift_m: Mapping[Hand, float]
    carrying: tuple[Hand, ...]
    phase: Phase
