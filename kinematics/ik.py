"""Whole-body inverse kinematics: what an answer is, and which solver a robot gets."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from kinematics import poses
from kinematics.errors import ModelError
from kinematics.poses import Transform
from kinematics.robot_description import Hand
from kinematics.robot_model import RobotModel
from kinematics.stance_table import StanceTable
from kinematics.trajectory import Stance

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class IkTolerance:
    """Residuals that an answer may have."""

    position_m: float = 5e-4
    orientation_rad: float = 3e-3
    com_margin_m: float = 0.0


@dataclass(frozen=True, slots=True)
class IkResult:
    """One inverse-kinematics answer, with the evidence to judge it by.

    Attributes:
        q: Configuration, shape (nq,), Pinocchio order; the soles are at the stance exactly.
        position_error_m: Distance of the TCP from its target.
        orientation_error_rad: Angle between TCP and target.
        com_margin_m: Distance of the CoM's ground projection to the edge of the support polygon,
            positive inside; infinite when the base is welded.
        limits_kept: Whether every joint is inside its limits (shrunk for planning).
        feet_reached: Whether the legs can be placed.
        iterations: Steps of the solver.
    """

    q: Array
    position_error_m: float
    orientation_error_rad: float
    com_margin_m: float
    limits_kept: bool
    feet_reached: bool
    iterations: int

    def within(self, tolerance: IkTolerance) -> bool:
        """Tell whether every residual is inside ``tolerance``."""
        return (
            self.feet_reached
            and self.limits_kept
            and self.position_error_m <= tolerance.position_m
            and self.orientation_error_rad <= tolerance.orientation_rad
            and self.com_margin_m >= tolerance.com_margin_m
        )


# With a CoM margin of 30 mm on paper, TALOS was seen to tip over slowly.
DEFAULT_TOLERANCE = IkTolerance(com_margin_m=0.05)


class InverseKinematics(Protocol):
    """Inverse kinematics of one hand for one stance."""

    def solve(
        self,
        world_T_tcp: Transform,
        q_seed: Array,
        tolerance: IkTolerance = DEFAULT_TOLERANCE,
        iterations: int = 60,
        q_preferred: Array | None = None,
        upright: bool = False,
    ) -> IkResult:
        """Bring the TCP to a pose, starting from a configuration with the feet at the stance.

        Args:
            world_T_tcp: Target, shape (4, 4).
            q_seed: Start, shape (nq,).
            tolerance: The search ends when the TCP is this near.
            iterations: Most steps of the solver.
            q_preferred: Posture to stay near where there is a choice; home when left out.
            upright: Give up, and quickly, where the knees would have to bend.
        """
        ...


@runtime_checkable
class FollowingKinematics(Protocol):
    """A solver that takes many poses at once."""

    def follow(
        self, world_T_tcp: Sequence[Transform], q_seed: Array, *, reserve_rad: float = 0.0
    ) -> list[IkResult]:
        """Bring the TCP to one pose after another; the answers as far as they are within the tolerance.

        Args:
            world_T_tcp: Targets, shape (4, 4) each.
            q_seed: Where it begins, shape (nq,).
            reserve_rad: Joints stay so much farther from their limits.
        """
        ...


def _make_solver(model: RobotModel, stance: Stance, hand: Hand) -> InverseKinematics:
    from kinematics.placo_ik import PlacoIk
    from kinematics.reach_ik import ReachIk

    try:
        return ReachIk(model, stance, hand)
    except ModelError:
        return PlacoIk(model, stance, hand)


inverse_kinematics = StanceTable(_make_solver)
"""The solver of a hand: compiled where the legs have a closed form, else PlaCo's."""


LINE_RESERVE_RAD = 0.015
"""Where joints are at their limits, a curve through a few solved points swings beyond them in between, by up
to 13 mrad: what is no way then may be one with this in reserve."""


def along_line(
    ik: InverseKinematics,
    q: Array,
    start: Transform,
    end: Transform,
    points: int,
    reserve_rad: float = 0.0,
) -> Array | None:
    """Configurations along a straight line of the TCP.

    Args:
        ik: Of the hand that moves.
        q: Configuration at the start of the line, shape (nq,); the first of the answer.
        start, end: Poses of the TCP, shape (4, 4).
        points: How many configurations, both ends included.
        reserve_rad: Joints stay so much farther from their limits, where the solver can do that.

    Returns:
        Shape (points, nq), or None when one of them is not reached within the tolerance.
    """
    targets = [poses.interpolate(start, end, k / (points - 1)) for k in range(1, points)]
    if isinstance(ik, FollowingKinematics):
        answers = ik.follow(targets, q, reserve_rad=reserve_rad)
        return np.array([q, *(answer.q for answer in answers)]) if len(answers) == len(targets) else None
    found = [q]
    for target in targets:
        result = ik.solve(target, found[-1], q_preferred=found[-1])
        if not result.within(DEFAULT_TOLERANCE):
            return None
        found.append(result.q)
    return np.array(found)


def errors_between(actual: Transform, wanted: Transform) -> tuple[float, float]:
    """Distance, m, and angle, rad, between two poses."""
    distance = math.dist(actual[:3, 3].tolist(), wanted[:3, 3].tolist())
    trace = float((actual[:3, :3] * wanted[:3, :3]).sum())
    return distance, math.acos(min(1.0, max(-1.0, (trace - 1.0) / 2.0)))
