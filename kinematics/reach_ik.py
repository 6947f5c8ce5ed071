"""Whole-body inverse kinematics in free coordinates: feet exact by construction, compiled."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from kinematics import planning_reserve
from kinematics.errors import MissingPartError, ModelError
from kinematics.free_coordinates import free_coordinates
from kinematics.ik import DEFAULT_TOLERANCE, IkResult, IkTolerance, errors_between
from kinematics.poses import Transform
from kinematics.robot_description import Hand
from kinematics.robot_model import RobotModel
from kinematics.stance import SupportPolygon
from kinematics.trajectory import Stance

if TYPE_CHECKING:
    from kinematics.kernel.coordinates import Limits
    from kinematics.kernel.reach_problem import ReachSpace

Array = NDArray[np.float64]

# How willingly a coordinate moves against a joint of the arm.
BASE_FREEDOM = np.array([0.02, 0.02, 0.02, 0.02, 0.02, 0.02])
TORSO_FREEDOM = 0.1
# The base stays within this of where it stands at home: position, m, and rotation vector, rad.
BASE_BELOW = np.array([0.25, 0.25, 0.45, 0.6, 0.9, 0.6])
BASE_ABOVE = np.array([0.25, 0.25, 0.05, 0.6, 0.9, 0.6])
# Knees bend no more than this lowers the base where the hand gets there without.
UPRIGHT_M = 0.15
UPRIGHT_TRIES = 2
DAMPING = 1e-5
PULL = 0.03
# A centimetre more than the limit, so that the checker's view never differs.
COM_RESERVE_M = 0.01
# Where it can be had, so much more: who stands at the edge cannot brake quickly.
STEADY_RESERVE_M = 0.045
# Soles are where they stand when no entry of their pose differs by more than this.
_SAME = 1e-9
_COM_ROUNDING_M = 1e-4


class ReachIk:
    """Inverse kinematics of one hand for one stance.

    Args:
        model: The robot; its legs need a closed form.
        stance: Where the soles stand.
        hand: The hand whose TCP is placed.

    Raises:
        MissingPartError: The robot has no such hand.
        ModelError: The legs have no closed form, or the base is welded.
    """

    def __init__(self, model: RobotModel, stance: Stance, hand: Hand) -> None:
        # imported here: they bring the compiler
        from kinematics.kernel import reach, reach_problem
        from kinematics.kernel.coordinates import standing_coordinates, standing_limits
        from kinematics.kernel.tree import tree_of

        description = model.description
        if description.welded:
            raise ModelError("the free coordinates of a welded robot have no base")
        self._reach, self._problem = reach.reach, reach_problem
        self._model = model
        self._space = free_coordinates(model, stance)
        self._polygon = SupportPolygon(stance, description.soles)
        self._tree = tree_of(model.pin)
        self._coordinates = standing_coordinates(model, stance)
        self._limits = standing_limits(model, stance)
        self._least = self._limits.offset - planning_reserve.COM_RESERVE_M
        self._com_margin_m = description.com_margin_m
        self._data = model.pin.createData()
        self._soles = [(model.frame_id(name), pose) for name, pose in stance.soles]
        if hand not in description.tcp_frames:
            raise MissingPartError(description.name, f"{hand} hand")
        self._tcp_id = model.frame_id(description.tcp_frames[hand])
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
        home = self._space.from_q(model.home_over(stance))
        columns = self._coordinates.columns - 7
        self._lower = np.concatenate([home[:6] - BASE_BELOW, self._joint_lower[columns]])
        self._upper = np.concatenate([home[:6] + BASE_ABOVE, self._joint_upper[columns]])
        self._freedom = np.zeros(self._space.size)
        self._freedom[:6] = BASE_FREEDOM
        for joint in description.groups["torso"]:
            self._freedom[self._space.index(joint)] = TORSO_FREEDOM
        for joint in description.groups[f"{hand}_arm"]:
            self._freedom[self._space.index(joint)] = 1.0
        self._moving = self._freedom > 0.0
        self._home = home
        column = np.full(len(self._tree.parent), -1, np.int64)
        column[[model.pin.getJointId(joint) for joint in self._space.joints]] = 6 + np.arange(len(columns))
        self._column = column
        self._memory = reach_problem.scratch(self._tree, model.nq, self._space.size)

    def solve(
        self,
        world_T_tcp: Transform,
        q_seed: Array,
        tolerance: IkTolerance = DEFAULT_TOLERANCE,
        iterations: int = 60,
        q_preferred: Array | None = None,
        upright: bool = False,
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
            starts: Further starts to try, as shares of the way through the bounds, shape (k, size).
        """
        kernel = self._problem
        body, offset_R, offset_p = self._tool
        seed = self._space.from_q(q_seed)
        preferred = self._home if q_preferred is None else self._space.from_q(q_preferred)
        where = kernel.ReachSpace(
            lower=np.where(self._moving, self._lower, seed),
            upper=np.where(self._moving, self._upper, seed),
            freedom=self._freedom,
            reference=np.where(self._moving, preferred, seed),
            column=self._column,
        )
        goal = kernel.ReachGoal(
            body,
            offset_R,
            offset_p,
            np.ascontiguousarray(world_T_tcp[:3, :3], dtype=np.float64),
            np.ascontiguousarray(world_T_tcp[:3, 3], dtype=np.float64),
        )
        settings = kernel.ReachSettings(
            0.5 * tolerance.position_m, 0.5 * tolerance.orientation_rad, DAMPING, PULL, iterations
        )
        taken = 0
        following = q_preferred is not None
        tries = self._tries(seed, where, starts, tolerance, following)
        if upright and not following:
            tries = itertools.islice(tries, UPRIGHT_TRIES)
        for limits, lower, start in tries:
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
        return self._verified(world_T_tcp, taken)

    def _tries(
        self, seed: Array, where: ReachSpace, starts: Array | None, tolerance: IkTolerance, following: bool
    ) -> Iterator[tuple[Limits, Array, Array]]:
        """Upright and well in balance first, then as far out and as low as is allowed, then elsewhere.

        Who follows a line stays in the posture that he has.
        """
        steady = self._limits._replace(offset=self._least + STEADY_RESERVE_M)
        reserve = max(COM_RESERVE_M, tolerance.com_margin_m - self._com_margin_m + _COM_ROUNDING_M)
        farthest = self._limits._replace(offset=self._least + reserve)
        if not following:
            upright = where.lower.copy()
            upright[2] = self._home[2] - UPRIGHT_M
            yield steady, upright, seed
            yield farthest, upright, seed
        yield steady, where.lower, seed
        yield farthest, where.lower, seed
        for share in () if starts is None else starts:
            yield farthest, where.lower, where.lower + share * (where.upper - where.lower)

    def _verified(self, world_T_tcp: Transform, count: int) -> IkResult:
        """Measure the last configuration again, with Pinocchio's kinematics instead of the kernel's."""
        q = self._memory.q.copy()
        model, data = self._model.pin, self._data
        pin.forwardKinematics(model, data, q)
        feet = all(
            np.abs(pin.updateFramePlacement(model, data, frame).homogeneous - pose).max() < _SAME
            for frame, pose in self._soles
        )
        tcp = pin.updateFramePlacement(model, data, self._tcp_id).homogeneous
        error, turn = errors_between(tcp, world_T_tcp)
        joints = q[7:]
        inside = (joints >= self._least_rad).all() and (joints <= self._most_rad).all()
        return IkResult(
            q=q,
            position_error_m=error,
            orientation_error_rad=turn,
            com_margin_m=self._polygon.com_margin_m(pin.centerOfMass(model, data)),
            limits_kept=bool(inside),
            feet_reached=feet,
            iterations=count,
        )
