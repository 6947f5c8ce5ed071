"""Come to a knob or a button, and turn a knob that is held."""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.model.robot_description import HANDS, Hand
from kinematics.requests.grasp import Grasp
from kinematics.requests.request import Request
from kinematics.requests.step import NoPlan, PlannedStep


@dataclass(frozen=True, slots=True)
class ControlPlan:
    """The way to a knob or button, and what is done there.

    Attributes:
        grasp: Where the hand is at the end of the approach: about the knob, or at the button.
        reach: The way to before it.
        approach: Straight on to it; of a button, which is pressed by feel, up to where the hand stops short.
        considered: How many ways were looked at.
        short_m: So far before a button what presses it is then.
    """

    grasp: Grasp
    reach: PlannedStep
    approach: PlannedStep
    considered: int
    short_m: float = 0.0


@dataclass(frozen=True, slots=True)
class ControlRequest(Request[ControlPlan | NoPlan]):
    """Plan to come to a knob or button that faces who stands before it.

    Attributes:
        control: Its name in the scene; x of its box points inwards, as the hand comes.
        turn_rad: How far a knob will be turned, clockwise for who looks at it; a way is taken from which the
            hand can do that. None where it is a button.
        short_m: So far before it the approach ends, or farther: a hand that feels its way goes on from there.
        hands: Hands that may be used, the better one first.
        excluded: Labels of ways, as "hand label", that were tried in vain.
        seed: Of everything random in the plan.
    """

    control: str
    turn_rad: float | None = None
    short_m: float = 0.0
    hands: tuple[Hand, ...] = HANDS
    excluded: frozenset[str] = frozenset()
    seed: int = 0


@dataclass(frozen=True, slots=True)
class TurnPlan:
    """A turn of a hand about its own axis, and the way straight back from there."""

    turn: PlannedStep
    back: PlannedStep


@dataclass(frozen=True, slots=True)
class TurnRequest(Request[TurnPlan | NoPlan]):
    """Plan to turn a hand, which holds a knob, about its own x axis.

    Attributes:
        control: The knob's name in the scene.
        hand: The hand.
        turn_rad: How far, clockwise for who looks along it.
    """

    control: str
    hand: Hand
    turn_rad: float
