"""Whole-body inverse kinematics: which solver a robot gets, and lines of the hand."""

from __future__ import annotations

import functools
import math
from collections.abc import Sequence
from typing import Protocol, cast, runtime_checkable

import numpy as np

from kinematics.arrays import Array
from kinematics.errors import ModelError
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.ik.result import DEFAULT_TOLERANCE, IkResult, IkTolerance
from kinematics.model.robot_description import Hand
from kinematics.model.standing_robot import StandingRobot


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
        lowest_m: float = -math.inf,
    ) -> IkResult:
        """Bring the TCP to a pose, starting from a configuration with the feet at the stance.

        Args:
            world_T_tcp: Target, shape (4, 4).
            q_seed: Start, shape (nq,).
            tolerance: The search ends when the TCP is this near.
            iterations: Most steps of the solver.
            q_preferred: Posture to stay near where there is a choice; home when left out.
            upright: Give up, and quickly, where the knees would have to bend.
            lowest_m: The base comes no lower, as far as the solver can be told so.
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


def _make_solver(robot: StandingRobot, hand: Hand) -> InverseKinematics:
    from kinematics.ik.placo_ik import PlacoIk
    from kinematics.ik.reach_ik import ReachIk
    from kinematics.ik.restarted_ik import RestartedIk

    if robot.model.description.welded:
        return RestartedIk(robot, hand)
    try:
        return ReachIk(robot, hand)
    except ModelError:
        return PlacoIk(robot, hand)


@functools.cache
def _follows(kind: type[InverseKinematics]) -> bool:
    """Whether a solver takes many poses at once; to ask a protocol takes as long as a step of the solver."""
    return issubclass(kind, FollowingKinematics)


def inverse_kinematics(robot: StandingRobot, hand: Hand) -> InverseKinematics:
    """The solver of a hand: compiled where the legs have a closed form, else PlaCo's; made once.

    On a welded base PlaCo's begins from several postures.
    """
    return robot.derived(_make_solver, hand)


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
    return along_poses(ik, q, list(poses.line(start, end, points)[1:]), reserve_rad)


def along_poses(
    ik: InverseKinematics, q: Array, targets: Sequence[Transform], reserve_rad: float = 0.0
) -> Array | None:
    """Configurations along poses of the TCP, each shape (4, 4); else as ``along_line``."""
    if _follows(type(ik)):
        answers = cast(FollowingKinematics, ik).follow(targets, q, reserve_rad=reserve_rad)
        return np.array([q, *(answer.q for answer in answers)]) if len(answers) == len(targets) else None
    found = [q]
    for target in targets:
        result = ik.solve(target, found[-1], q_preferred=found[-1])
        if not result.within(DEFAULT_TOLERANCE):
            return None
        found.append(result.q)
    return np.array(found)
