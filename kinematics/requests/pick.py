"""Grasp an object and lift it."""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.arrays import Array, Sealed
from kinematics.model.robot_description import HANDS, Hand
from kinematics.model.stance import Stance
from kinematics.requests.grasp import Grasp
from kinematics.requests.step import PlannedStep
from kinematics.scene.planning_scene import PlanningScene


@dataclass(frozen=True, slots=True)
class PickRequest(Sealed):
    """Plan reach, approach and lift for one object of the scene.

    Attributes:
        q_start: Configuration to start from (the commanded reference), shape (nq,).
        stance: Where the feet stand.
        scene: What is around; holds the target.
        target: Name of the object.
        hands: Hands that may be used.
        excluded: Labels of grasps, as "hand label", that were tried in vain.
        lift_m: How far to lift, straight up.
        seed: Of everything random in the plan.
    """

    q_start: Array
    stance: Stance
    scene: PlanningScene
    target: str
    hands: tuple[Hand, ...] = HANDS
    excluded: frozenset[str] = frozenset()
    lift_m: float = 0.13
    seed: int = 0


@dataclass(frozen=True, slots=True)
class PickPlan:
    """Reach, approach and lift; between approach and lift the gripper closes.

    Attributes:
        grasp: The chosen grasp.
        reach, approach, lift: In order; each starts where the one before ends.
        considered: How many grasps were looked at.
    """

    grasp: Grasp
    reach: PlannedStep
    approach: PlannedStep
    lift: PlannedStep
    considered: int
