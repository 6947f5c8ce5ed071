"""The way of a handle: the arc of a door's, the line of a drawer's.

``s`` says how far it is open: rad of a door, m of a drawer; it is measured from closed. Frame: odometry.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from kinematics.arrays import Array, Sealed
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform

UP = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True, slots=True)
class HandlePoint(Sealed):
    """Where a handle is, and which way it goes, while its door or drawer is open by a certain amount.

    Attributes:
        position_m: Its bar's middle, shape (3,).
        outward: Horizontal unit vector in which opening moves it, shape (3,).
        across: Horizontal unit vector along which it must not be forced: from the hinge to the bar, or
            across a drawer, shape (3,).
    """

    position_m: Array
    outward: Array
    across: Array


class OpeningPath(Protocol):
    """The way of a handle as its door or drawer opens.

    It is a function of the opening ``s``, which is 0 when shut: rad for a door, m for a drawer.
    """

    @property
    def lever_m(self) -> float:
        """Way of the handle for one unit of ``s``, m."""
        ...

    @property
    def bar_axis(self) -> Array:
        """Unit vector along the bar while closed, shape (3,)."""
        ...

    def at(self, s: float) -> HandlePoint:
        """The handle at an opening."""
        ...

    def part_moved(self, odom_T_solid: Transform, s_from: float, s_to: float) -> Transform:
        """Pose at one opening of a solid of the door or drawer, from its pose at another."""
        ...

    def through(self, position_m: Array, s: float) -> OpeningPath:
        """The same path, of a handle that is at a place, shape (3,), at opening ``s``."""
        ...


@dataclass(frozen=True, slots=True)
class DoorArc(Sealed):
    """The way of a door's handle: an arc about the hinge, in the odometry frame.

    Attributes:
        hinge_m: A point of the hinge's axis on the floor, shape (2,).
        closed_yaw_rad: Heading of the inward normal while closed: who opens it looks that way.
        side: +1 when it hangs on the left, seen by who opens it; -1 on the right.
        radius_m: From the axis to the bar along the door.
        standoff_m: From the plane of the axis to the bar, outwards.
        height_m: Of the bar's middle.
    """

    hinge_m: Array
    closed_yaw_rad: float
    side: float
    radius_m: float
    standoff_m: float
    height_m: float

    @property
    def lever_m(self) -> float:
        """Distance of the bar from the axis."""
        return float(np.hypot(self.radius_m, self.standoff_m))

    @property
    def bar_axis(self) -> Array:
        """Upright."""
        return UP

    def at(self, s: float) -> HandlePoint:
        """The handle with the door open by ``s`` rad."""
        turn = poses.rotation_z(self.closed_yaw_rad - self.side * s)
        along, normal = turn @ np.array([0.0, -self.side, 0.0]), turn @ np.array([-1.0, 0.0, 0.0])
        arm = self.radius_m * along + self.standoff_m * normal
        place = np.array([self.hinge_m[0], self.hinge_m[1], self.height_m]) + arm
        across = arm / self.lever_m
        outward = self.side * np.array([across[1], -across[0], 0.0])
        return HandlePoint(place, outward, across)

    def part_moved(self, odom_T_solid: Transform, s_from: float, s_to: float) -> Transform:
        """Turn a solid about the hinge."""
        axis = poses.translation(float(self.hinge_m[0]), float(self.hinge_m[1]), 0.0)
        turn = poses.transform(poses.rotation_z(-self.side * (s_to - s_from)), (0.0, 0.0, 0.0))
        return np.asarray(axis @ turn @ poses.inverse(axis) @ odom_T_solid)

    def through(self, position_m: Array, s: float) -> DoorArc:
        """The same hinge, with the bar where it was found to be."""
        turn = poses.rotation_z(self.closed_yaw_rad - self.side * s)
        arm = turn.T @ np.array([*(position_m[:2] - self.hinge_m), 0.0])
        return DoorArc(
            self.hinge_m,
            self.closed_yaw_rad,
            self.side,
            float(-self.side * arm[1]),
            float(-arm[0]),
            float(position_m[2]),
        )


@dataclass(frozen=True, slots=True)
class DrawerLine(Sealed):
    """The way of a drawer's handle: a straight line, in the odometry frame.

    Attributes:
        closed_m: The bar's middle while closed, shape (3,).
        yaw_rad: Heading of who opens it: the drawer comes the other way.
    """

    closed_m: Array
    yaw_rad: float

    @property
    def lever_m(self) -> float:
        """A metre a metre."""
        return 1.0

    @property
    def bar_axis(self) -> Array:
        """Across the drawer, to the left."""
        return np.asarray(poses.rotation_z(self.yaw_rad)[:, 1])

    def at(self, s: float) -> HandlePoint:
        """The handle with the drawer open by ``s`` m."""
        turn = poses.rotation_z(self.yaw_rad)
        outward = -turn[:, 0]
        return HandlePoint(self.closed_m + s * outward, outward, turn[:, 1])

    def part_moved(self, odom_T_solid: Transform, s_from: float, s_to: float) -> Transform:
        """Shift a solid."""
        moved = odom_T_solid.copy()
        moved[:3, 3] += (s_to - s_from) * self.at(0.0).outward
        return moved

    def through(self, position_m: Array, s: float) -> DrawerLine:
        """The same direction, with the bar where it was found to be."""
        return DrawerLine(position_m - s * self.at(0.0).outward, self.yaw_rad)
