"""What one can ask of the gesture planner: motions that mean something to a person.

All are frozen values, answered by a ``MovePlan`` or a ``NoPlan``.
"""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.model.robot_description import HANDS, Hand
from kinematics.requests.move import MovePlan
from kinematics.requests.request import Request
from kinematics.requests.step import NoPlan

Point = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class RaiseHandRequest(Request[MovePlan | NoPlan]):
    """Turn the trunk to a point and raise one hand beside the head, fingers up: ready to wave.

    Attributes:
        hand: The hand to raise.
        towards_m: What to turn to; its height does not matter.
        seed: Of everything random in the plan.
    """

    hand: Hand
    towards_m: Point
    seed: int = 0


@dataclass(frozen=True, slots=True)
class SwingRequest(Request[MovePlan | NoPlan]):
    """Swing a raised hand from side to side, and bring it back to where it was.

    Attributes:
        hand: The hand to swing.
        width_m: From one side to the other.
        swings: How often it goes from one side to the other.
    """

    hand: Hand
    width_m: float
    swings: int


@dataclass(frozen=True, slots=True)
class PointRequest(Request[MovePlan | NoPlan]):
    """Stretch an arm so that the line through forearm and hand meets a point.

    Attributes:
        target_m: What to point at.
        hands: Hands that may be used; the first that can is taken, the nearer one before the other.
        seed: Of everything random in the plan.
    """

    target_m: Point
    hands: tuple[Hand, ...] = HANDS
    seed: int = 0


@dataclass(frozen=True, slots=True)
class OfferRequest(Request[MovePlan | NoPlan]):
    """Bring a held object, upright, to where a person can take it comfortably.

    Attributes:
        held: Name of the object, an attached body of the scene.
        person_m: The axis of the person; its height does not matter.
        seed: Of everything random in the plan.
    """

    held: str
    person_m: Point
    seed: int = 0


@dataclass(frozen=True, slots=True)
class CarryRequest(Request[MovePlan | NoPlan]):
    """Bring a held object, upright, before the shoulder, and the trunk and pelvis home: ready to walk.

    Attributes:
        held: Name of the object, an attached body of the scene.
        seed: Of everything random in the plan.
    """

    held: str
    seed: int = 0


GestureRequest = RaiseHandRequest | SwingRequest | PointRequest | OfferRequest | CarryRequest
