"""How the CoM moves above the floor: along one straight stretch of the ZMP, or to rest."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Protocol

from kinematics.walking.dcm import Point, ZmpStretch
from kinematics.walking.quintic import Quintic


@dataclass(frozen=True, slots=True)
class ComSample:
    """One instant.

    Attributes:
        com, dcm, zmp: On the floor, m.
    """

    com: Point
    dcm: Point
    zmp: Point


class ComMotion(Protocol):
    """A closed form of the CoM's motion.

    Attributes:
        duration_s: It is meant for this long.
    """

    duration_s: float

    def at(self, t_s: float) -> ComSample:
        """Instant of it, from 0 at its beginning."""
        ...


class SteeredCom:
    """The CoM while the ZMP moves in a straight line.

    ``c = z + a e^(w t) + b e^(-w t)``, which gives ``xi = z + z'/w + 2 a e^(w t)``.
    """

    def __init__(self, stretch: ZmpStretch, com: Point, dcm: Point, omega: float) -> None:
        """Begin at a CoM and a DCM."""
        self.duration_s = stretch.duration_s
        self._omega = omega
        duration_s = max(stretch.duration_s, 1e-9)
        (x0, y0), (x1, y1) = stretch.start, stretch.end
        vx, vy = (x1 - x0) / duration_s, (y1 - y0) / duration_s
        ax, ay = 0.5 * (dcm[0] - x0 - vx / omega), 0.5 * (dcm[1] - y0 - vy / omega)
        self._x = (x0, vx, ax, com[0] - x0 - ax)
        self._y = (y0, vy, ay, com[1] - y0 - ay)

    def at(self, t_s: float) -> ComSample:
        """Instant of it."""
        growth = math.exp(self._omega * t_s)
        cx, ex, zx = self._along(self._x, t_s, growth)
        cy, ey, zy = self._along(self._y, t_s, growth)
        return ComSample((cx, cy), (ex, ey), (zx, zy))

    def _along(
        self, axis: tuple[float, float, float, float], t_s: float, growth: float
    ) -> tuple[float, float, float]:
        start, slope, a, b = axis
        zmp = start + slope * t_s
        return zmp + a * growth + b / growth, zmp + slope / self._omega + 2.0 * a * growth, zmp


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
                omega * omega * (now.com[k] - now.zmp[k]),
                rest[k],
                duration_s,
            )
            for k in (0, 1)
        )

    def at(self, t_s: float) -> ComSample:
        """Instant of it; at rest after its end."""
        (cx, vx, ax), (cy, vy, ay) = (axis.at(t_s) for axis in self._axes)
        w = self._omega
        return ComSample((cx, cy), (cx + vx / w, cy + vy / w), (cx - ax / (w * w), cy - ay / (w * w)))
