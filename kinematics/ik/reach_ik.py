"""Whole-body inverse kinematics in free coordinates: feet exact by construction, compiled."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np
import pinocchio as pin

from kinematics.arrays import Array, as_float64
from kinematics.errors import MissingPartError, ModelError
from kinematics.geometry.poses import Transform
from kinematics.ik.result import DEFAULT_TOLERANCE, IkResult, IkTolerance, errors_between
from kinematics.model.robot_build import model_tree, planning_memory
from kinematics.model.robot_description import Hand
from kinematics.model.standing_robot import StandingRobot
from kinematics.standing import reserves as planning_reserve
from kinematics.standing.free_coordinates import free_coordinates

if TYPE_CHECKING:
    from kinematics.ik.reach_problem import ReachGoal, ReachSettings, ReachSpace
    from kinematics.standing.flat_coordinates import Limits


# How willingly a coordinate moves against a joint of the arm.
BASE_FREEDOM = np.array([0.02, 0.02, 0.02, 0.02, 0.02, 0.02])
TORSO_FREEDOM = 0.1
# The base stays within this of where it stands at home: position, m, and rotation vector, rad.
BASE_BELOW = (0.25, 0.25, 0.45)
BASE_ABOVE = (0.25, 0.25, 0.05)
BASE_TURN_RAD = 0.6
# Of the lean that the body may have forward or back, what it may have aside.
_ASIDE = 2.0 / 3.0
# Knees bend no more than this lowers the base where the hand gets there without.
UPRIGHT_M = 0.15
UPRIGHT_TRIES = 2
DAMPING = 1e-5
PULL = 0.03
# Where it can be had, so much more: who stands at the edge cannot brake quickly.
STEADY_RESERVE_M = 0.045
# Soles are where they stand when no entry of their pose differs by more than this.
_SAME = 1e-9
_COM_ROUNDING_M = 1e-4


class ReachIk:
    """Inverse kinematics of one hand for one stance.

    Args:
        robot: Where it stands; its legs need a closed form.
        hand: The hand whose TCP is placed.

    Raises:
        MissingPartError: The robot has no such hand.
        ModelError: The legs have no closed form, or the base is welded.
    """

    def __init__(self, robot: StandingRobot, hand: Hand) -> None:
        # imported here: they bring the compiler
        from kinematics.ik import reach, reach_problem
        from kinematics.standing.model_coordinates import standing_coordinates, standing_limits

        model, soles = robot.model, robot.stance.soles
        description = model.description
        if description.welded:
            raise ModelError("the free coordinates of a welded robot have no base")
        self._reach, self._reach_in_turn, self._problem = reach.reach, reach.reach_in_turn, reach_problem
        self._model = model
        self._space, self._polygon = free_coordinates(robot), robot.polygon
        self._tree = model_tree(model)
        self._coordinates = standing_coordinates(robot)
        self._limits = standing_limits(robot)
        self._least = self._limits.offset - planning_reserve.COM_RESERVE_M
        self._last_start: tuple[Array, Array, ReachSpace] | None = None
        self._margins_by_reserve: dict[float, tuple[Limits, Limits]] = {}
        self._com_margin_m, self._data = description.com_margin_m, planning_memory(model)
        self._soles = np.array([pose for _, pose in soles])
        if hand not in description.tcp_frames:
            raise MissingPartError(description.name, f"{hand} hand")
        self._tcp_id = model.frame_id(description.tcp_frames[hand])
        self._frames = [self._tcp_id, *(model.frame_id(name) for name, _ in soles)]
        frame = model.pin.frames[self._tcp_id]
        placement = np.array(frame.placement.homogeneous)
        self._tool = (
            int(frame.parentJoint),
            np.ascontiguousarray(placement[:3, :3]),
            np.ascontiguousarray(placement[:3, 3]),
        )
        margin = description.planning_margin_rad
        self._joint_lower, self._joint_upper = model.lower_rad + margin, model.upper_rad - margin
        self._least_rad = self._joint_lower - planning_reserve.LIMIT_NOISE_RAD
        self._most_rad = self._joint_upper + planning_reserve.LIMIT_NOISE_RAD
        home = self._space.from_q(robot.q_home)
        columns = self._coordinates.columns - 7
        lean_rad = description.lean_rad
        turns = (_ASIDE * lean_rad, lean_rad, BASE_TURN_RAD)
        below, above = np.array([*BASE_BELOW, *turns]), np.array([*BASE_ABOVE, *turns])
        self._lower = np.concatenate([home[:6] - below, self._joint_lower[columns]])
        self._upper = np.concatenate([home[:6] + above, self._joint_upper[columns]])
        self._freedom = np.zeros(self._space.size)
        self._freedom[:6] = BASE_FREEDOM
        for joint in description.groups["torso"]:
            self._freedom[self._space.index(joint)] = TORSO_FREEDOM
        for joint in description.groups[f"{hand}_arm"]:
            self._freedom[self._space.index(joint)] = 1.0
        self._moving = self._freedom > 0.0
        self._is_joint = np.arange(self._space.size) >= 6
        self._home = home
        column = np.full(len(self._tree.parent), -1, np.int64)
        column[[model.pin.getJointId(joint) for joint in self._space.joints]] = 6 + np.arange(len(columns))
        self._column = column
        self._memory = reach_problem.scratch(
            self._tree, model.nq, self._space.size, self._coordinates.leg_bodies, self._tool[0]
        )

    def solve(
        self,
        world_T_tcp: Transform,
        q_seed: Array,
        tolerance: IkTolerance = DEFAULT_TOLERANCE,
        iterations: int = 60,
        q_preferred: Array | None = None,
        upright: bool = False,
        lowest_m: float = -math.inf,
        starts: Array | None = None,
    ) -> IkResult:
        """Bring the TCP to a pose, starting from a configuration with the feet at the stance.

        Args:
            world_T_tcp: Target, shape (4, 4).
            q_seed: Start, shape (nq,); what does not move stays as it is there.
            tolerance: The search ends when the TCP is this near.
            iterations: Most steps from one start.
            q_preferred: Posture to stay near where there is a choice; home when left out.
            upright: Try only what does not bend the knees: half of the time where nothing is found.
            lowest_m: The base comes no lower.
            starts: Further starts to try, as shares of the way through the bounds, shape (k, size).

        Raises:
            InvalidArrayError: One has another shape, or holds no real numbers.
        """
        world_T_tcp = as_float64(world_T_tcp, (4, 4), "world_T_tcp")
        q_seed = as_float64(q_seed, (self._model.nq,), "q_seed")
        if starts is not None:
            starts = as_float64(starts, (None, self._space.size), "starts")
        if q_preferred is None:
            seed, where = self._search_from(q_seed)
        else:
            seed = self._space.from_q(q_seed)
            where = self._search(seed, self._space.from_q(q_preferred))
        if lowest_m > where.lower[2]:
            lower = where.lower.copy()
            lower[2] = min(lowest_m, float(self._home[2]))
            where = where._replace(lower=lower)
        goal = self._goal(world_T_tcp)
        settings = self._settings(tolerance, iterations)
        taken = 0
        following = q_preferred is not None
        tries = self._tries(seed, where, starts, tolerance, following)
        if upright and not following:
            tries = itertools.islice(tries, UPRIGHT_TRIES)
        tried: list[tuple[Limits, Array, bool, bool]] = []
        for limits, lower, start in tries:
            if start is seed and any(_same_way(limits, lower, *other) for other in tried):
                continue
            x = start.copy()
            steps = self._reach(
                self._tree,
                self._coordinates,
                limits,
                goal,
                where._replace(lower=lower),
                settings,
                x,
                self._memory,
            )
            taken += iterations if steps < 0 else steps
            if steps >= 0:
                break
            unbalanced, at_lowest = self._memory.noted.tolist()
            tried.append((limits, lower, bool(unbalanced), bool(at_lowest)))
        return self._measured(self._memory.q[None].copy(), world_T_tcp[None], [taken])[0]

    def follow(
        self,
        world_T_tcp: Sequence[Transform],
        q_seed: Array,
        tolerance: IkTolerance = DEFAULT_TOLERANCE,
        iterations: int = 60,
        reserve_rad: float = 0.0,
    ) -> list[IkResult]:
        """Bring the TCP to one pose after another, staying near to the posture at the one before.

        As ``solve`` with each answer for the next seed and for the posture preferred, in one call.

        Args:
            world_T_tcp: Targets, shape (4, 4) each.
            q_seed: Where it begins, shape (nq,).
            tolerance: As for ``solve``.
            iterations: Most steps from one start, for each of them.
            reserve_rad: Joints stay so much farther from their limits.

        Returns:
            Answers as far as they are within the tolerance.

        Raises:
            InvalidArrayError: One has another shape, or holds no real numbers.
        """
        if len(world_T_tcp) == 0:
            return []
        targets = as_float64(world_T_tcp, (None, 4, 4), "world_T_tcp")
        x = self._space.from_q(q_seed)
        where = self._search(x, x, reserve_rad)
        x = np.clip(x, where.lower, where.upper)
        found = np.empty((len(world_T_tcp), self._model.nq))
        steady, farthest = self._margins(tolerance)
        reached = self._reach_in_turn(
            self._tree,
            self._coordinates,
            steady,
            farthest.offset,
            self._goal(targets[0]),
            targets,
            where,
            self._settings(tolerance, iterations),
            x,
            found,
            self._memory,
        )
        answers = self._measured(found[:reached], targets[:reached], [0] * reached)
        return list(itertools.takewhile(lambda answer: answer.within(tolerance), answers))

    def _search_from(self, q_seed: Array) -> tuple[Array, ReachSpace]:
        """Start and search near home; kept, as many grasps are tried from one start."""
        known = self._last_start
        if known is None or not np.array_equal(known[0], q_seed):
            seed = self._space.from_q(q_seed)
            known = self._last_start = q_seed.copy(), seed, self._search(seed, self._home)
        return known[1:]

    def _search(self, seed: Array, preferred: Array, reserve_rad: float = 0.0) -> ReachSpace:
        """Where it is searched: what does not move stays at the seed."""
        reserve = np.where(self._is_joint, reserve_rad, 0.0)
        return self._problem.ReachSpace(
            lower=np.where(self._moving, self._lower + reserve, seed),
            upper=np.where(self._moving, self._upper - reserve, seed),
            freedom=self._freedom,
            reference=np.where(self._moving, preferred, seed),
            column=self._column,
        )

    def _goal(self, world_T_tcp: Transform) -> ReachGoal:
        body, offset_R, offset_p = self._tool
        return self._problem.ReachGoal(
            body,
            offset_R,
            offset_p,
            np.array(world_T_tcp[:3, :3]),
            np.array(world_T_tcp[:3, 3]),
        )

    def _settings(self, tolerance: IkTolerance, iterations: int) -> ReachSettings:
        return self._problem.ReachSettings(
            0.5 * tolerance.position_m, 0.5 * tolerance.orientation_rad, DAMPING, PULL, iterations
        )

    def _margins(self, tolerance: IkTolerance) -> tuple[Limits, Limits]:
        """Limits with the CoM's margin that is liked, and with the one that is asked for."""
        reserve = max(
            planning_reserve.SEARCH_COM_RESERVE_M,
            tolerance.com_margin_m - self._com_margin_m + _COM_ROUNDING_M,
        )
        found = self._margins_by_reserve.get(reserve)
        if found is None:
            found = self._margins_by_reserve[reserve] = (
                self._limits._replace(offset=self._least + STEADY_RESERVE_M),
                self._limits._replace(offset=self._least + reserve),
            )
        return found

    def _tries(
        self, seed: Array, where: ReachSpace, starts: Array | None, tolerance: IkTolerance, following: bool
    ) -> Iterator[tuple[Limits, Array, Array]]:
        """Upright and well in balance first, then as far out and as low as is allowed, then elsewhere.

        Who follows a line stays in the posture that he has.
        """
        steady, farthest = self._margins(tolerance)
        if not following:
            upright = where.lower.copy()
            upright[2] = self._home[2] - UPRIGHT_M
            yield steady, upright, seed
            yield farthest, upright, seed
        yield steady, where.lower, seed
        yield farthest, where.lower, seed
        for share in () if starts is None else starts:
            yield farthest, where.lower, where.lower + share * (where.upper - where.lower)

    def _measured(self, q: Array, world_T_tcp: Array, counts: Sequence[int]) -> list[IkResult]:
        """Measure configurations again, with Pinocchio's kinematics instead of the kernel's.

        Args:
            q: Shape (n, nq).
            world_T_tcp: What was asked for, shape (n, 4, 4).
            counts: Steps taken for each.
        """
        model, data = self._model.pin, self._data
        placed = np.empty((len(q), len(self._frames), 4, 4))
        com = np.empty((len(q), 3))
        for row, posture in enumerate(q):
            pin.forwardKinematics(model, data, posture)
            for k, frame in enumerate(self._frames):
                placed[row, k] = pin.updateFramePlacement(model, data, frame).homogeneous
            com[row] = pin.centerOfMass(model, data)
        joints = q[:, 7:]
        room = np.minimum(joints - self._least_rad, self._most_rad - joints).min(axis=1).tolist()
        stray = np.abs(placed[:, 1:] - self._soles).max(axis=(1, 2, 3)).tolist()
        margins = self._polygon.margins_m(com[:, :2]).tolist()
        answers = []
        for row, count in enumerate(counts):
            error, turn = errors_between(placed[row, 0], world_T_tcp[row])
            answers.append(
                IkResult(q[row], error, turn, margins[row], room[row] >= 0.0, stray[row] < _SAME, count)
            )
        return answers


def _same_way(
    limits: Limits, lower: Array, before: Limits, lower_before: Array, unbalanced: bool, at_lowest: bool
) -> bool:
    """Whether a search from the same start would go as one before did, which came to nothing.

    It does where the bounds that differ were never met.
    """
    same_margin = limits is before or (not unbalanced and bool((limits.offset <= before.offset).all()))
    same_bounds = lower is lower_before or (not at_lowest and bool((lower <= lower_before).all()))
    return same_margin and same_bounds
