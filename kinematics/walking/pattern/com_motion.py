"""How the CoM moves above the floor: along one straight stretch of the ZMP, or to rest."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Protocol

from kinematics.geometry.quintic import Quintic
from kinematics.walking.pattern.dcm import Cubic, Point, ZmpStretch, particular, polynomial


@dataclass(frozen=True, slots=True)
class ComSample:
    """The CoM at one instant of a walk.

    Attributes:
        com, dcm: Centre of mass and divergent component of motion, on the floor, m.
        pivot: What the CoM is accelerated away from: ``c'' = w^2 (c - pivot)``.
        zmp: Where the floor presses; the swinging leg is the difference (``kinematics.walking.pattern.dcm``).
    """

    com: Point
    dcm: Point
    pivot: Point
    zmp: Point


class ComMotion(Protocol):
    """A closed form of the CoM's motion.

    Attributes:
        duration_s: How long it goes on.
    """

    duration_s: float

    def at(self, t_s: float) -> ComSample:
        """Instant of it, from 0 at its beginning."""
        ...


class SteeredCom:
    """The CoM along one stretch: ``c = c_p + a e^(w t) + b e^(-w t)`` gives ``xi = xi_p + 2 a e^(w t)``."""

    def __init__(self, stretch: ZmpStretch, com: Point, dcm: Point, omega: float) -> None:
        """Begin at a CoM and a DCM."""
        self.duration_s = stretch.duration_s
        self._omega, self._sway = omega, stretch.sway
        axes = []
        for k in (0, 1):
            pivot = stretch.pivot(k)
            com_p, dcm_p = particular(pivot, 0.0, omega)
            a = 0.5 * (dcm[k] - dcm_p)
            axes.append((pivot, a, com[k] - com_p - a))
        self._x, self._y = axes

    def at(self, t_s: float) -> ComSample:
        """Instant of it."""
        growth = math.exp(self._omega * t_s)
        cx, ex, px, zx = self._along(self._x, self._sway[0], t_s, growth)
        cy, ey, py, zy = self._along(self._y, self._sway[1], t_s, growth)
        return ComSample((cx, cy), (ex, ey), (px, py), (zx, zy))

    def _along(
        self, axis: tuple[Cubic, float, float], sway: Cubic, t_s: float, growth: float
    ) -> tuple[float, float, float, float]:
        pivot, a, b = axis
        com_p, dcm_p = particular(pivot, t_s, self._omega)
        at = polynomial(pivot, t_s)
        return com_p + a * growth + b / growth, dcm_p + 2.0 * a * growth, at, at - polynomial(sway, t_s)


class SettlingCom:
    """The CoM on its way to rest: the polynomial of fifth order from a state to a point."""

    def __init__(self, now: ComSample, rest: Point, duration_s: float, omega: float) -> None:
        """Begin at an instant, with its velocity and acceleration."""
        self.duration_s = duration_s
        self._omega = omega
        self._axes = tuple(
            Quintic.to_rest(
                now.com[k],
                omega * (now.dcm[k] - now.com[k]),
                omega * omega * (now.com[k] - now.pivot[k]),
                rest[k],
                duration_s,
            )
            for k in (0, 1)
        )

    def at(self, t_s: float) -> ComSample:
        """Instant of it; at rest after its end."""
        (cx, vx, ax), (cy, vy, ay) = (axis.at(t_s) for axis in self._axes)
        w = self._omega
        zmp = cx - ax / (w * w), cy - ay / (w * w)
        return ComSample((cx, cy), (cx + vx / w, cy + vy / w), zmp, zmp)
