"""One way to grasp an object."""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.arrays import Sealed
from kinematics.geometry.poses import Transform
from kinematics.model.robot_description import Hand


@dataclass(frozen=True, slots=True)
class Grasp(Sealed):
    """A way to take hold of an object.

    Attributes:
        hand: Which hand.
        label: Short name, unique among the object's candidates: "side 30 deg", "top 45 deg".
        world_T_tcp: Pose of the TCP when the fingers close, shape (4, 4).
        approach_m: Length of the straight approach along the TCP's x axis.
        diameter_m: Opening that is expected when the pads hold the object.
        off_centre_m: Where the middle of the object is along the opening then, from the TCP: not between the
            pads where it is held by a handle or a neck.
        opening_m: How far the fingers open before that, where more would touch what is beside; None for all
            the way.
    """

    hand: Hand
    label: str
    world_T_tcp: Transform
    approach_m: float
    diameter_m: float
    off_centre_m: float = 0.0
    opening_m: float | None = None
