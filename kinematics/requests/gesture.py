"""What one can ask of the gesture planner: motions that mean something to a person.

All are frozen values, answered by a ``MovePlan`` or a ``NoPlan``.
"""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.arrays import Array, Sealed
from kinematics.model.robot_description import HANDS, Hand
from kinematics.model.stance import Stance
from kinematics.scene.planning_scene import PlanningScene

Point = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class RaiseHandRequest(Sealed):
    """Turn the trunk to a point and raise one hand beside the head, fingers up: ready to wave.

    Attributes:
        q_start: Configuration to start from, shape (nq,).
        stance: Where the feet stand.
        scene: What is around.
        hand: The hand to raise.
        towards_m: What to turn to; its height does not matter.
        seed: Of everything random in the plan.
    """

    q_start: Array
    stance: Stance
    scene: PlanningScene
    hand: Hand
    towards_m: Point
    seed: int = 0


@dataclass(frozen=True, slots=True)
class SwingRequest(Sealed):
    """Swing a raised hand from side to side, and bring it back to where it was.

    Attributes:
        q_start: Configuration to start from, shape (nq,).
        stance: Where the feet stand.
        scene: What is around.
        hand: The hand to swing.
        width_m: From one side to the other.
        swings: How often it goes from one side to the other.
    """

    q_start: Array
    stance: Stance
    scene: PlanningScene
    hand: Hand
    width_m: float
    swings: int


@dataclass(frozen=True, slots=True)
class PointRequest(Sealed):
    """Stretch an arm so that the line through forearm and hand meets a point.

    Attributes:
        q_start: Configuration to start from, shape (nq,).
        stance: Where the feet stand.
        scene: What is around.
        target_m: What to point at.
        hands: Hands that may be used; the first that can is taken, the nearer one before the other.
        seed: Of everything random in the plan.
    """

    q_start: Array
    stance: Stance
    scene: PlanningScene
    target_m: Point
    hands: tuple[Hand, ...] = HANDS
    seed: int = 0


@dataclass(frozen=True, slots=True)
class OfferRequest(Sealed):
    """Bring a held object, upright, to where a person can take it comfortably.

    Attributes:
        q_start: Configuration to start from, shape (nq,).
        stance: Where the feet stand.
        scene: What is around; the object is an attached body of it.
        held: Name of the attached body.
        person_m: The axis of the person; its height does not matter.
        seed: Of everything random in the plan.
    """

    q_start: Array
    stance: Stance
    scene: PlanningScene
    held: str
    person_m: Point
    seed: int = 0


@dataclass(frozen=True, slots=True)
class CarryRequest(Sealed):
    """Bring a held object, upright, before the shoulder, and the trunk and pelvis home: ready to walk.

    Attributes:
        q_start: Configuration to start from, shape (nq,).
        stance: Where the feet stand.
        scene: What is around; the object is an attached body of it.
        held: Name of the attached body.
        seed: Of everything random in the plan.
    """

    q_start: Array
    stance: Stance
    scene: PlanningScene
    held: str
    seed: int = 0


GestureRequest = RaiseHandRequest | SwingRequest | PointRequest | OfferRequest | CarryRequest
