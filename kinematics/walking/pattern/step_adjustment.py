"""Whether the sole that stands can bring the DCM where the next landing needs it, and how much it misses by.

With the ZMP at ``p`` the DCM goes from ``xi`` to ``p + (xi - p) e^(w t)`` until the landing. The best ``p``
of the sole leaves a rest, and by that rest the landing has to move: what follows then finds the DCM where
it belongs. Source: Khadiv et al., "Walking control based on step timing adaptation", IEEE Transactions
on Robotics 36(3), 2020, section III, with the time of the landing left as it is.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from kinematics.geometry.planar import PlanarPose
from kinematics.walking.pattern.com_motion import SteeredCom
from kinematics.walking.pattern.dcm import Point, ZmpStretch, dcm_after, zmp_that_leads

Stretches = Callable[[Point], Sequence[ZmpStretch]]

_LOOKS = 6
"""Instants of each stretch at which the legs' reach is looked at."""
_TO_REST_PEAK = 5.774
"""Peak acceleration of the polynomial of fifth order from rest to rest: so many times distance / time^2."""


def missed_by(
    through: Stretches, on_sole: Callable[[Point], Point], dcm: Point, wanted: Point, omega: float
) -> Point:
    """How far from where it is wanted a DCM ends, with the ZMP at the best place of the sole, m.

    Args:
        through: What the ZMP does until then, for a place of it; linear in the place.
        on_sole: The nearest place that the sole allows.
        dcm: Now, as measured.
        wanted: Where the landing needs it.
        omega: Natural frequency, 1/s.
    """
    best = on_sole(zmp_that_leads(through, dcm, wanted, omega))
    x, y = dcm_after(through(best), dcm, omega)
    return x - wanted[0], y - wanted[1]


def farthest_m(left_s: float, acceleration_m_s2: float) -> float:
    """How far a landing may move when so much time is left, with that much more acceleration of the foot."""
    return acceleration_m_s2 * left_s * left_s / _TO_REST_PEAK


def legs_reach(
    stretches: Sequence[ZmpStretch],
    com: Point,
    dcm: Point,
    omega: float,
    standing: PlanarPose,
    flying: Callable[[float], PlanarPose],
    reach_m: float,
) -> bool:
    """Whether no foot gets too far from the CoM, neither the one that stands nor the one in the air.

    Args:
        stretches: What the ZMP does, from now on.
        com, dcm: Of the plan, now.
        omega: Natural frequency, 1/s.
        standing: The foot on the floor.
        flying: Above which place the other one is so many seconds from now; where it lands from then on.
        reach_m: Most distance over the floor.
    """
    since_s = 0.0
    for stretch in stretches:
        motion = SteeredCom(stretch, com, dcm, omega)
        for k in range(1, _LOOKS + 1):
            t_s = stretch.duration_s * k / _LOOKS
            at = motion.at(t_s)
            feet = standing, flying(since_s + t_s)
            if any(math.hypot(foot.x_m - at.com[0], foot.y_m - at.com[1]) > reach_m for foot in feet):
                return False
        com, dcm = at.com, at.dcm
        since_s += stretch.duration_s
    return True
