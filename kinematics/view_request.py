"""What one can ask of the view planner."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Sealed
from kinematics.scene import PlanningScene
from kinematics.trajectory import Stance

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class ViewRequest(Sealed):
    """Take the eyes to where most of some points are seen; answered by ``MovePlan`` or ``NoPlan``.

    Attributes:
        q_start: Configuration to start from, shape (nq,).
        stance: Where the feet stand.
        scene: What is around, and hides things.
        points_m: What is to be seen, world, shape (n, 3).
        worth: Of each point, shape (n,).
        clear_m: A line of sight keeps this far from hands and elbows.
        seed: Of everything random in the plan.
    """

    q_start: Array
    stance: Stance
    scene: PlanningScene
    points_m: Array
    worth: Array
    clear_m: float
    seed: int = 0
