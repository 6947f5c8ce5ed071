"""Which part of the ground's wrench each sole of a standing robot takes.

With two soles down the parts are under-determined. Here every sole is pressed at the same place, seen from
its own origin: where the ZMP is halfway to the polygon's edge, each centre of pressure is halfway to its
sole's edge, and the loads are what that asks for. So no sole of two side by side is asked to press outside
itself while the ZMP is inside the polygon. The smallest wrenches, moments counting ten times dearer than
forces, ask a foot that carries a sixth of TALOS for twice the moment that tips it. The servos bore the
difference: 4 mrad at the other ankle, and half a second of swinging after a quick reach.
"""

from __future__ import annotations

import math

import numpy as np

from kinematics.arrays import Array
from kinematics.model.robot_description import SoleDescription
from kinematics.model.stance import Stance


class SoleShares:
    """Shares out the wrench of the ground between the soles of one stance."""

    def __init__(self, stance: Stance, soles: tuple[SoleDescription, ...]) -> None:
        """Prepare.

        Args:
            stance: One sole or two; none of a welded robot.
            soles: The robot's, with the sizes of those.

        Raises:
            ValueError: If more than two soles carry.
        """
        poses = [world_T_sole for _, world_T_sole in stance.soles]
        if len(poses) > 2:
            raise ValueError(f"a stance of {len(poses)} soles: one or two are shared out between")
        self._at = [tuple(pose[:3, 3].tolist()) for pose in poses]
        # share of the last sole: offset and slope over the ZMP, per m
        self._share_at_origin, self._slope = 1.0, (0.0, 0.0)
        self._height_m = stance.height_m
        if len(poses) == 2:
            (ax, ay, _), (bx, by, _) = self._at
            apart = math.hypot(bx - ax, by - ay)
            ux, uy = (bx - ax) / apart, (by - ay) / apart
            sizes = {sole.frame: sole for sole in soles}
            (first, first_pose), (last, last_pose) = stance.soles
            outwards = min(
                _extent(first_pose, sizes[first], -ux, -uy), _extent(last_pose, sizes[last], ux, uy)
            )
            across = apart + 2.0 * outwards
            self._slope = (ux / across, uy / across)
            self._share_at_origin = 0.5 - ((ax + bx) * ux + (ay + by) * uy) / (2.0 * across)

    def wrenches(self, net: Array) -> Array:
        """Wrenches of the soles, force before moment, about the world's origin, shape (6 k,).

        Args:
            net: The ground's, about that origin, N and Nm, shape (6,).
        """
        fx, fy, fz, mx, my, mz = net.tolist()
        if len(self._at) != 2:  # one takes all of it, bolts without any the same
            return net
        lift = max(fz, 1e-6)
        x, y = self._height_m * fx - my, self._height_m * fy + mx
        last = self._share_at_origin + (self._slope[0] * x + self._slope[1] * y) / lift
        last = min(max(last, 0.0), 1.0)
        (ax, ay, az), (bx, by, bz) = self._at
        first = 1.0 - last
        px, py, pz = first * ax + last * bx, first * ay + last * by, first * az + last * bz
        # what the forces at the soles leave over, in the same parts
        rx, ry, rz = mx - py * fz + pz * fy, my - pz * fx + px * fz, mz - px * fy + py * fx
        return np.array(
            [
                part * value
                for part, (x, y, z) in ((first, self._at[0]), (last, self._at[1]))
                for value in (
                    fx,
                    fy,
                    fz,
                    rx + y * fz - z * fy,
                    ry + z * fx - x * fz,
                    rz + x * fy - y * fx,
                )
            ]
        )


def _extent(world_T_sole: Array, sole: SoleDescription, ux: float, uy: float) -> float:
    """How far a sole reaches from its origin along a horizontal direction, m."""
    along_x = world_T_sole[0, 0] * ux + world_T_sole[1, 0] * uy
    along_y = world_T_sole[0, 1] * ux + world_T_sole[1, 1] * uy
    return float(max(x * along_x + y * along_y for x in sole.x_m for y in sole.y_m))
