"""What one can ask of the motion planner and the checker, and what they answer.

All are frozen values, so that they can be sent to a worker process.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Sealed
from kinematics.concessions import Concession
from kinematics.gesture_requests import GestureRequest
from kinematics.opening_path import OpeningPath
from kinematics.place_requests import PlaceRequest
from kinematics.poses import Transform
from kinematics.robot_description import HANDS, Hand
from kinematics.scene import PlanningScene
from kinematics.trajectory import Stance, Trajectory
from kinematics.view_request import ViewRequest

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Grasp(Sealed):
    """A way to take hold of an object.

    Attributes:
        hand: Which hand.
        label: Short name, unique among the object's candidates: "side 30 deg", "top 45 deg".
        world_T_tcp: Pose of the TCP when the fingers close, shape (4, 4).
        approach_m: Length of the straight approach along the TCP's x axis.
        diameter_m: Opening that is expected when the pads hold the object.
    """

    hand: Hand
    label: str
    world_T_tcp: Transform
    approach_m: float
    diameter_m: float


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
class MoveRequest(Sealed):
    """Plan a motion to body joint positions; joints left out go home.

    Attributes:
        q_start: Configuration to start from, shape (nq,).
        stance: Where the feet stand.
        scene: What is around.
        joints: Goal positions of some body joints, rad.
        keep_others: Joints left out stay where they are instead of going home.
        pelvis_m: How far the pelvis goes beside, in the world, shape (3,); nothing for a welded base.
        seed: Of everything random in the plan.
    """

    q_start: Array
    stance: Stance
    scene: PlanningScene
    joints: Mapping[str, float] = field(default_factory=dict)
    keep_others: bool = False
    pelvis_m: tuple[float, float, float] = (0.0, 0.0, 0.0)
    seed: int = 0


@dataclass(frozen=True, slots=True)
class RetreatRequest(Sealed):
    """Plan a straight motion of one TCP along its own axis or the world's, e.g. back out of a grasp.

    Attributes:
        q_start: Configuration to start from, shape (nq,).
        stance: Where the feet stand.
        scene: What is around.
        hand: Hand to move.
        world_offset_m: Where the TCP goes, relative to where it is, in the world, shape (3,).
        steady_m: CoM margin that is wanted along the way; of the ways that are allowed, the first that has
            it is taken.
        shares: Of the offset, which may be gone, in order of preference.
        turns_rad: By which the hand may turn about the vertical meanwhile, in order of preference.
        concessions: What may touch on the way: what the fingers held, what carries a held object.
    """

    q_start: Array
    stance: Stance
    scene: PlanningScene
    hand: Hand
    world_offset_m: tuple[float, float, float]
    steady_m: float = 0.05
    shares: tuple[float, ...] = (1.0,)
    turns_rad: tuple[float, ...] = (0.0,)
    concessions: tuple[Concession, ...] = ()


@dataclass(frozen=True, slots=True)
class HandleRequest(Sealed):
    """Plan to take hold of a handle, with the whole way of it within reach.

    Attributes:
        q_start: Configuration to start from, shape (nq,).
        stance: Where the feet stand.
        scene: What is around; holds the handle and what it opens.
        handle: Name of the handle's bar in the scene.
        parts: Names of everything that moves with it, the bar included.
        path: Where the handle goes.
        s_from, s_to: How far it is open, and shall be; rad or m.
        hands: Hands that may be used, the better one first.
        excluded: Labels of grasps, as "hand label", that were tried in vain.
        seed: Of everything random in the plan.
        pushed: The name of the front, when the hand shall push against that instead of holding the bar.
    """

    q_start: Array
    stance: Stance
    scene: PlanningScene
    handle: str
    parts: tuple[str, ...]
    path: OpeningPath
    s_from: float
    s_to: float
    hands: tuple[Hand, ...] = HANDS
    excluded: frozenset[str] = frozenset()
    seed: int = 0
    pushed: str = ""


@dataclass(frozen=True, slots=True)
class HandlePlan:
    """Reach and approach to a handle; after them the gripper closes and the hand follows the path.

    Attributes:
        grasp: The chosen grasp.
        reach, approach: In order.
        farthest_s: Up to where along the path the hand was found to get; short of ``s_to`` by at most
            what the request's planner leaves.
        considered: How many grasps were looked at.
    """

    grasp: Grasp
    reach: PlannedStep
    approach: PlannedStep
    farthest_s: float
    considered: int


@dataclass(frozen=True, slots=True)
class CheckRequest:
    """Judge a trajectory against a scene; answered by CheckedTrajectory or Unsafe.

    Attributes:
        trajectory: The motion.
        scene: What is around and in the hands, as the world model has it.
        concessions: What the motion's planner asks to be overlooked; the checker says how much of it is.
    """

    trajectory: Trajectory
    scene: PlanningScene
    concessions: tuple[Concession, ...] = ()


@dataclass(frozen=True, slots=True)
class PlannedStep:
    """A trajectory with the scene that it is to be judged in.

    Attributes:
        name: "reach", "approach", ...
        trajectory: The motion.
        scene: As it was given to the planner; of a lift, with the object in the hand.
        concessions: Where the motion does not keep that scene's margins, and why.
    """

    name: str
    trajectory: Trajectory
    scene: PlanningScene
    concessions: tuple[Concession, ...] = ()

    @property
    def question(self) -> CheckRequest:
        """What the checker is to be asked."""
        return CheckRequest(self.trajectory, self.scene, self.concessions)


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
class MovePlan:
    """One motion."""

    step: PlannedStep


@dataclass(frozen=True, slots=True)
class NoPlan:
    """An honest "no".

    Attributes:
        message: One sentence for people.
        reasons: How many candidates failed for which reason.
        numbers: Figures behind the message, keys with their unit.
    """

    message: str
    reasons: Mapping[str, int]
    numbers: Mapping[str, float] = field(default_factory=dict)


PlanRequest = (
    PickRequest
    | MoveRequest
    | RetreatRequest
    | HandleRequest
    | PlaceRequest
    | GestureRequest
    | ViewRequest
    | CheckRequest
)
