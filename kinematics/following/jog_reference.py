"""What a person's jogging asks for at one instant: a velocity of a hand, or of one joint."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from kinematics.arrays import Array, Sealed
from kinematics.model.robot_description import Hand

JogFrame = Literal["world", "base", "tool"]
FRAMES: tuple[JogFrame, ...] = get_args(JogFrame)
"""The directions that a hand is jogged along: of the odometry frame, of the pelvis, of the TCP itself."""


@dataclass(frozen=True, slots=True)
class HandJog(Sealed):
    """A velocity of a hand's TCP.

    Attributes:
        hand: Which.
        frame: Whose axes the velocities are along.
        linear_m_s: Shape (3,).
        angular_rad_s: About the TCP, shape (3,).
    """

    hand: Hand
    frame: JogFrame
    linear_m_s: Array
    angular_rad_s: Array


@dataclass(frozen=True, slots=True)
class JointJog:
    """A velocity of one joint of trunk, arms or head.

    Attributes:
        joint: Its name.
        rate_rad_s: Its velocity.
    """

    joint: str
    rate_rad_s: float


Jog = HandJog | JointJog
