"""Move to a configuration, or back out of where the hand is."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from kinematics.model.robot_description import Hand
from kinematics.requests.request import Request
from kinematics.requests.step import NoPlan, PlannedStep
from kinematics.scene.concessions import Concession


@dataclass(frozen=True, slots=True)
class MovePlan:
    """The answer to a request that one motion fulfils."""

    step: PlannedStep


@dataclass(frozen=True, slots=True)
class MoveRequest(Request[MovePlan | NoPlan]):
    """Plan a motion to body joint positions; joints left out go home.

    Attributes:
        joints: Goal positions of some body joints, rad.
        keep_others: Joints left out stay where they are instead of going home.
        level: Where what is in a hand would lean on the way, beyond its leans at both ends, there is no plan.
            Otherwise that is avoided where it can be.
        pelvis_m: How far the pelvis moves meanwhile, along the axes of the world, shape (3,); a welded base
            does not.
        seed: Of everything random in the plan.
    """

    joints: Mapping[str, float] = field(default_factory=dict)
    keep_others: bool = False
    level: bool = False
    pelvis_m: tuple[float, float, float] = (0.0, 0.0, 0.0)
    seed: int = 0


@dataclass(frozen=True, slots=True)
class RetreatRequest(Request[MovePlan | NoPlan]):
    """Plan a straight motion of one TCP along its own axis or the world's, e.g. back out of a grasp.

    Attributes:
        hand: Hand to move.
        world_offset_m: Where the TCP goes, relative to where it is, in the world, shape (3,).
        steady_m: CoM margin that is wanted along the way; of the ways that are allowed, the first that has
            it is taken.
        shares: Fractions of the offset that will do, in order of preference.
        turns_rad: Angles by which the hand may turn about the vertical meanwhile, in order of preference.
        concessions: What may touch on the way: what the fingers held, what carries a held object.
    """

    hand: Hand
    world_offset_m: tuple[float, float, float]
    steady_m: float = 0.05
    shares: tuple[float, ...] = (1.0,)
    turns_rad: tuple[float, ...] = (0.0,)
    concessions: tuple[Concession, ...] = ()
