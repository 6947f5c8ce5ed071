"""What one can ask of the view planner."""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.arrays import Array, Sealed
from kinematics.model.stance import Stance
from kinematics.scene.planning_scene import PlanningScene


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
