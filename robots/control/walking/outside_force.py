"""Tells that something holds a walking body back: legs and trunk have no sensor of their own for that.

What changes the momentum and does not come from the soles comes from elsewhere:
``F = d(m v)/dt - sum of the soles' forces``, on the floor, as a mean over a while. Of a push of a moment only
one of two such means in a row knows; what is met goes on.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Mapping, Sequence

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry.planar import PlanarPose
from kinematics.model.robot_description import Hand
from kinematics.walking.pattern.dcm import Point
from robots.control.gate.refusal import Limit, Refusal

MOST_N = 80.0
"""Undisturbed walks show 12 N at most, plates 26, pushes of 0.1 s 43; walls and tables that are walked into
94 to 326."""
_MEAN_S = 0.3
"""Of each of the two means: half a step."""
_EVERY = 25
"""Periods between two looks."""


class OutsideForce:
    """Estimates the force of the surroundings on the robot: what the soles' forces do not explain."""

    def __init__(
        self, mass_kg: float, sides: Sequence[Hand], period_s: float, foot_error_n: float = 0.0
    ) -> None:
        """Begin to walk.

        Args:
            mass_kg: Of the robot with what it carries.
            sides: Of the soles, in the order of the wrenches.
            period_s: The control period.
            foot_error_n: By so much the soles' forces may be wrong: what pushes has to be larger.
        """
        self._most_n = MOST_N + foot_error_n
        self._mass_kg, self._sides = mass_kg, sides
        self._look_s = _EVERY * period_s
        self._forces = np.zeros((len(sides), 3))
        self._periods = 0
        self._impulse: Point = (0.0, 0.0)
        self._half = round(_MEAN_S / self._look_s)
        self._missing: deque[Point] = deque(maxlen=2 * self._half + 1)

    def feel(
        self,
        foot_wrench: Array,
        feet: Mapping[Hand, PlanarPose],
        tilt: Callable[[Hand], Array],
        velocity_m_s: Point,
    ) -> Refusal | None:
        """Take a period in.

        Args:
            foot_wrench: Of the ground on each sole in the sole's frame, N, Nm, shape (soles, 6).
            feet: Where the soles are, in the plan's frame.
            tilt: How each of them leans, beside its heading, shape (3, 3): a degree makes 16 N of the weight.
            velocity_m_s: Of the CoM, in that frame.

        Returns:
            How hard something pushes, if that is too hard.
        """
        self._forces += foot_wrench[:, :3]
        self._periods += 1
        if self._periods % _EVERY:
            return None
        x, y = self._impulse
        share = self._look_s / _EVERY
        for side, force in zip(self._sides, self._forces, strict=True):
            ahead, aside, _ = tilt(side).dot(force).tolist()
            c, s = math.cos(feet[side].yaw_rad), math.sin(feet[side].yaw_rad)
            x += share * (c * ahead - s * aside)
            y += share * (s * ahead + c * aside)
        self._forces[:] = 0.0
        self._impulse = x, y
        self._missing.append((self._mass_kg * velocity_m_s[0] - x, self._mass_kg * velocity_m_s[1] - y))
        if len(self._missing) < 2 * self._half + 1:
            return None
        old, middle, new = self._missing[0], self._missing[self._half], self._missing[-1]
        first, last = _mean(old, middle), _mean(middle, new)
        force_n = min(math.hypot(*first), math.hypot(*last))
        if force_n <= self._most_n or first[0] * last[0] + first[1] * last[1] <= 0.0:
            return None
        return Refusal(Limit.FORCE, "something on the body", force_n, self._most_n)


def _mean(before: Point, after: Point) -> Point:
    """Force between two looks, N."""
    return (after[0] - before[0]) / _MEAN_S, (after[1] - before[1]) / _MEAN_S
