"""What one can ask of the place planner; frozen values, answered by a ``PlacePlan`` or a ``NoPlan``."""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.arrays import Sealed
from kinematics.geometry.poses import Transform
from kinematics.model.robot_description import Hand
from kinematics.requests.request import Request
from kinematics.requests.step import NoPlan, PlannedStep


@dataclass(frozen=True, slots=True)
class PlacePlan(Sealed):
    """Over the spot, and straight down; the way back of the hand was looked at, and is planned later.

    Attributes:
        hand: The hand that holds the object.
        spot: Index of the chosen spot.
        world_T_object: Where the object will stand, shape (4, 4).
        transfer, lower: In order; each starts where the one before ends.
        considered: How many poses were looked at.
    """

    hand: Hand
    spot: int
    world_T_object: Transform
    transfer: PlannedStep
    lower: PlannedStep
    considered: int


@dataclass(frozen=True, slots=True)
class Spot(Sealed):
    """Where an object could be put down.

    Attributes:
        world_T_object: Its pose at rest there, shape (4, 4); the planner chooses the turn about the
            vertical.
        touches: Names of what it may touch there: what carries it, the walls of a container.
        hover_m: How far above that the way straight down begins.
        below_m: How far below that it ends, for the support may be lower than it seems.
    """

    world_T_object: Transform
    touches: tuple[str, ...]
    hover_m: float = 0.06
    below_m: float = 0.005


@dataclass(frozen=True, slots=True)
class PlaceRequest(Request[PlacePlan | NoPlan]):
    """Plan to bring a held object over one of several spots, down onto it, and the hand away from it.

    Attributes:
        held: Name of the object, an attached body of the scene.
        spots: Where it may go, the best first.
        retreat_m: How far the hand is drawn back along its approach, at the end.
        quick: Look no longer than it takes where there is a plan in plain view; a "no" says little then. For
            who asks about many places to stand.
        seed: Of everything random in the plan.
    """

    held: str
    spots: tuple[Spot, ...]
    retreat_m: float = 0.10
    quick: bool = False
    seed: int = 0
