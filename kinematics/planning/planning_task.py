"""What planners of several steps share: paces, margins, points along a line."""

from __future__ import annotations

from kinematics.timing.curve_timing import Pace

SELF_MARGIN_M = 0.005


# Points of the straight approach and lift that are solved; a cubic runs through them.
CARTESIAN_POINTS = 4


REACH_PACE = Pace(velocity=0.5, acceleration=0.7)


CARTESIAN_PACE = Pace(velocity=0.2, acceleration=0.5)
