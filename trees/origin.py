"""Where something stood before a hand took it."""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.arrays import Sealed
from kinematics.poses import Transform


@dataclass(frozen=True, slots=True)
class Origin(Sealed):
    """A place on a piece of furniture.

    Attributes:
        support: What it stood on, as the planning scene names it.
        odom_T_object: Its pose there, shape (4, 4).
    """

    support: str
    odom_T_object: Transform
