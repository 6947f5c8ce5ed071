"""Grasp an object and lift it."""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.model.robot_description import HANDS, Hand
from kinematics.requests.grasp import Grasp
from kinematics.requests.request import Request
from kinematics.requests.step import NoPlan, PlannedStep


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


@dataclass(frozen=True, slots=True)
class PickRequest(Request[PickPlan | NoPlan]):
    """Plan reach, approach and lift for one object of the scene.

    Attributes:
        target: Name of the object, which the scene holds.
        hands: Hands that may be used.
        excluded: Labels of grasps, as "hand label", that were tried in vain.
        lift_m: How far to lift, straight up.
        seed: Of everything random in the plan.
    """

    target: str
    hands: tuple[Hand, ...] = HANDS
    excluded: frozenset[str] = frozenset()
    lift_m: float = 0.13
    seed: int = 0
