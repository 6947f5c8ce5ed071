"""Points of the floor that soles give: their middles, what they can be pressed at, where the CoM rests."""

from __future__ import annotations

from collections.abc import Mapping

from kinematics.geometry.planar import PlanarPose
from kinematics.model.robot_description import Hand, SoleDescription
from kinematics.walking.pattern.dcm import Point


class SolePoints:
    """The corners of a robot's soles on the floor, wherever its feet stand."""

    def __init__(self, soles: Mapping[Hand, SoleDescription], rest_m: Point) -> None:
        """Take them.

        Args:
            soles: The robot's.
            rest_m: Where the CoM rests, seen from the middle between the feet.
        """
        self._soles, self._rest_m = soles, rest_m

    def resting(self, feet: Mapping[Hand, PlanarPose]) -> Point:
        """Where the CoM rests above both feet."""
        pose = PlanarPose.between(feet["left"], feet["right"]) @ PlanarPose(*self._rest_m)
        return pose.x_m, pose.y_m

    def middle(self, side: Hand, foot: PlanarPose) -> Point:
        """Where the ZMP is when a foot stands alone: the middle of its sole."""
        sole = self._soles[side]
        pose = foot @ PlanarPose(0.5 * sum(sole.x_m), 0.5 * sum(sole.y_m))
        return pose.x_m, pose.y_m

    def nearest(self, zmp: Point, side: Hand, foot: PlanarPose, inset_m: float) -> Point:
        """The point of a foot's sole, less an inset, nearest to a ZMP."""
        sole = self._soles[side]
        seen = foot.to(PlanarPose(*zmp))
        x = min(max(seen.x_m, sole.x_m[0] + inset_m), sole.x_m[1] - inset_m)
        y = min(max(seen.y_m, sole.y_m[0] + inset_m), sole.y_m[1] - inset_m)
        if x == seen.x_m and y == seen.y_m:
            return zmp
        pose = foot @ PlanarPose(x, y)
        return pose.x_m, pose.y_m

    def held_by_both(self, dcm: Point, feet: Mapping[Hand, PlanarPose], inset_m: float) -> bool:
        """Whether both soles, side by side and less an inset, have a point under a DCM: what holds it.

        Between feet that do not stand side by side the rectangle around them is taken.
        """
        seen = PlanarPose.between(feet["left"], feet["right"]).to(PlanarPose(*dcm))
        middle = PlanarPose.between(feet["left"], feet["right"])
        x: list[float] = []
        y: list[float] = []
        for side, sole in self._soles.items():
            for corner_x in sole.x_m:
                for corner_y in sole.y_m:
                    corner = middle.to(feet[side] @ PlanarPose(corner_x, corner_y))
                    x.append(corner.x_m)
                    y.append(corner.y_m)
        inside_x = min(x) + inset_m <= seen.x_m <= max(x) - inset_m
        return inside_x and min(y) + inset_m <= seen.y_m <= max(y) - inset_m
