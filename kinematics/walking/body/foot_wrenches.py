"""The stabiliser: from the DCM's error to the wrenches that the soles shall get from the floor.

The ZMP is moved beyond the DCM's error so that the DCM comes back: ``z = z_ref + (1 + k) (xi - xi_ref)``.
It is shared out between the feet that carry, each keeping its part inside its sole, and the trunk is
righted by moments. Source: Kajita et al., "Biped walking stabilization based on linear inverted pendulum
tracking", IROS 2010, section III; the DCM form is that of Englsberger et al.
(``kinematics.walking.pattern.dcm``).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry.planar import PlanarPose
from kinematics.model.robot_description import Hand, SoleDescription
from kinematics.model.walking_settings import WalkingSettings
from kinematics.walking.pattern.dcm import Point

_GRAVITY_M_S2 = 9.81
_LEAST_SHARE = 0.02
"""Of the load, on a foot that carries at all."""


@dataclass(frozen=True, slots=True)
class SoleWrench:
    """What the floor shall do to a sole, in the plan's axes.

    Attributes:
        force_n: Force, shape (3,).
        moment_nm: Moment about the sole's origin, shape (3,).
        at_m: The sole's origin, shape (3,).
    """

    force_n: Array
    moment_nm: Array
    at_m: Array


@dataclass(frozen=True, slots=True)
class Wrenches:
    """The wrenches of the floor on all soles at one instant, and what they achieve together.

    Attributes:
        soles: The wrench on each sole that carries, by foot.
        zmp: Where the ZMP is under these wrenches, on the floor in the plan's frame, m.
    """

    soles: Mapping[Hand, SoleWrench]
    zmp: Point


class WrenchDistribution:
    """Shares the floor's force out between the feet."""

    def __init__(
        self, settings: WalkingSettings, soles: Mapping[Hand, SoleDescription], mass_kg: float, omega: float
    ) -> None:
        self._settings, self._soles, self._mass_kg, self._omega = settings, soles, mass_kg, omega

    def wrenches(
        self,
        zmp_ref: Point,
        error: Point,
        pull: Point,
        feet: Mapping[Hand, PlanarPose],
        carrying: Sequence[Hand],
        righting_nm: Array,
    ) -> Wrenches:
        """Wrenches for one instant, everything in the plan's frame.

        Args:
            zmp_ref: Where the plan has the ZMP.
            error: Measured DCM less the plan's, m.
            pull: How far the CoM is, as measured, from what the plan has it accelerated away from, m.
            feet: Where the soles are.
            carrying: The feet that carry.
            righting_nm: Moment on the trunk, shape (3,).
        """
        gain = 1.0 + self._settings.dcm_gain
        wanted = (zmp_ref[0] + gain * error[0], zmp_ref[1] + gain * error[1])
        shares = self._shares(wanted, feet, carrying)
        middle_x = sum(share * feet[side].x_m for side, share in shares.items())
        middle_y = sum(share * feet[side].y_m for side, share in shares.items())
        off = (wanted[0] - middle_x, wanted[1] - middle_y)
        pressed = {side: self._pressed(side, feet[side], off) for side in shares}
        zmp = (
            sum(share * pressed[side][0] for side, share in shares.items()),
            sum(share * pressed[side][1] for side, share in shares.items()),
        )
        stiffness = self._mass_kg * self._omega**2
        fx = stiffness * (pull[0] - zmp[0] + zmp_ref[0])
        fy = stiffness * (pull[1] - zmp[1] + zmp_ref[1])
        fz = self._mass_kg * _GRAVITY_M_S2
        soles = {}
        for side, share in shares.items():
            foot = feet[side]
            rx, ry = pressed[side][0] - foot.x_m, pressed[side][1] - foot.y_m
            force = share * np.array((fx, fy, fz))
            moment = share * (np.array((ry * fz, -rx * fz, rx * fy - ry * fx)) + righting_nm)
            soles[side] = SoleWrench(force, moment, np.array((foot.x_m, foot.y_m, 0.0)))
        return Wrenches(soles, zmp)

    def _shares(
        self, zmp: Point, feet: Mapping[Hand, PlanarPose], carrying: Sequence[Hand]
    ) -> dict[Hand, float]:
        if len(carrying) == 1:
            return {carrying[0]: 1.0}
        first, second = carrying
        a, b = feet[first], feet[second]
        dx, dy = b.x_m - a.x_m, b.y_m - a.y_m
        along = ((zmp[0] - a.x_m) * dx + (zmp[1] - a.y_m) * dy) / (dx * dx + dy * dy)
        along = min(max(along, _LEAST_SHARE), 1.0 - _LEAST_SHARE)
        return {first: 1.0 - along, second: along}

    def _pressed(self, side: Hand, foot: PlanarPose, off: Point) -> Point:
        """Centre of pressure of a sole: as far off its origin as the whole is, but inside the sole."""
        sole, inset = self._soles[side], self._settings.zmp_inset_m
        c, s = math.cos(foot.yaw_rad), math.sin(foot.yaw_rad)
        x = min(max(c * off[0] + s * off[1], sole.x_m[0] + inset), sole.x_m[1] - inset)
        y = min(max(c * off[1] - s * off[0], sole.y_m[0] + inset), sole.y_m[1] - inset)
        return foot.x_m + c * x - s * y, foot.y_m + s * x + c * y
