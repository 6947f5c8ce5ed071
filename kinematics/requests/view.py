"""What one can ask of the view planner."""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.arrays import Array
from kinematics.requests.move import MovePlan
from kinematics.requests.request import Request
from kinematics.requests.step import NoPlan


@dataclass(frozen=True, slots=True)
class ViewRequest(Request[MovePlan | NoPlan]):
    """Take the eyes to where most of some points are seen; answered by ``MovePlan`` or ``NoPlan``.

    Attributes:
        points_m: What is to be seen, world, shape (n, 3).
        worth: Of each point, shape (n,).
        clear_m: A line of sight keeps this far from hands and elbows.
        seed: Of everything random in the plan.
    """

    points_m: Array
    worth: Array
    clear_m: float
    seed: int = 0
