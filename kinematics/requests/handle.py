"""Grasp a handle and lead it."""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.model.robot_description import HANDS, Hand
from kinematics.requests.grasp import Grasp
from kinematics.requests.request import Request
from kinematics.requests.step import NoPlan, PlannedStep
from kinematics.scene.opening_path import OpeningPath


@dataclass(frozen=True, slots=True)
class HandlePlan:
    """Reach and approach to a handle; after them the gripper closes and the hand follows the path.

    Attributes:
        grasp: The chosen grasp.
        reach, approach: The two steps, in this order.
        lead_to: Where along the path, rad or m, the hand is to be led: to ``s_to`` of the request, or where a
            front is shut that is pushed by a hand that keeps its heading.
        considered: How many grasps were looked at.
    """

    grasp: Grasp
    reach: PlannedStep
    approach: PlannedStep
    lead_to: float
    considered: int


@dataclass(frozen=True, slots=True)
class HandleRequest(Request[HandlePlan | NoPlan]):
    """Plan to take hold of a handle, with the whole way of it within reach.

    Attributes:
        handle: Name of the handle's bar in the scene, which holds what it opens, too.
        parts: Names of everything that moves with it, the bar included.
        path: Where the handle goes.
        s_from, s_to: How far it is open, and shall be; rad or m.
        hands: Hands that may be used, the better one first.
        excluded: Labels of grasps, as "hand label", that were tried in vain.
        seed: Of everything random in the plan.
        pushed: The name of the front, when the hand shall push against that instead of holding the bar.
        beside: Names of what is fixed around the bar, of a piece that is known by a model: fingers that fit
            in between may come near it.
    """

    handle: str
    parts: tuple[str, ...]
    path: OpeningPath
    s_from: float
    s_to: float
    hands: tuple[Hand, ...] = HANDS
    excluded: frozenset[str] = frozenset()
    seed: int = 0
    pushed: str = ""
    beside: tuple[str, ...] = ()
