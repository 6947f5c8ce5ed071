"""How far the judge and the search go before they look elsewhere: none of it can make a claim false."""

from __future__ import annotations

from typing import NamedTuple


class Tuning(NamedTuple):
    """Numbers found by trying; given as data, so that trying compiles nothing.

    Attributes:
        first_reach_rad: An edge is cut into intervals in which no joint moves farther than this, before
            any pair is looked at.
        hopeless: A closer look at a pair is not worth while when less than this part of the motion bound
            uses up the distance.
        enough: GJK goes on until it has proven so many times what the last direction had to prove.
        point_step_rad: So far apart are the points at which an edge is asked first, in the joint that
            moves farthest.
        shortcut_m: A shortcut that comes nearer than about this to anything is not worth its proof.
        shortcut_effort: Most intervals of a shortcut.
        shortcut_gain: A corner is worth cutting off when that saves this part of the way.
    """

    first_reach_rad: float
    hopeless: float
    enough: float
    point_step_rad: float
    shortcut_m: float
    shortcut_effort: float
    shortcut_gain: float
