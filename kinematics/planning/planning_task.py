"""One planning problem: what is asked of a robot, the scene that it begins in, and steps made of curves.

Planners of several steps derive their problems from it; those of one step use it as it is.
"""

from __future__ import annotations

import dataclasses
import math
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from typing import TypeVar

import numpy as np

from kinematics.arrays import Array
from kinematics.collision.relaxed_start import relaxed_at, start_concessions
from kinematics.collision.validity import validity
from kinematics.dynamics.standing_dynamics import StandingDynamics
from kinematics.ik.solver import InverseKinematics, inverse_kinematics
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.curves import Curve
from kinematics.motion.lead_in import lead_in
from kinematics.motion.trajectory import Trajectory
from kinematics.planning.path_planner import PathPlanner
from kinematics.requests.request import Request
from kinematics.requests.step import PlannedStep
from kinematics.scene.concessions import Concession
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing.free_coordinates import free_coordinates
from kinematics.timing.balanced_timing import time_in_balance
from kinematics.timing.curve_timing import Pace

C = TypeVar("C")
P = TypeVar("P")

SELF_MARGIN_M = 0.005
"""Kept between the robot's own links where nothing else is said."""

BORNE_SHARE = 0.95
"""Of what a motor gives, what a plan may take of it: other loads of the feet take the rest."""
CROUCHED_SHARE = 0.72
"""Of the base's height at home; below 0.7 it has fallen."""
LEANING_RAD = 0.65
"""Of the base; beyond 0.7 it is falling."""
_EVERY = 8
"""Samples of a motion between two looks at its efforts; the checker looks at all."""
_ROUNDING_M = 1e-3
CARTESIAN_POINTS = 4
"""Points of the straight approach and lift that are solved; a cubic runs through them."""

REACH_PACE = Pace(velocity=0.5, acceleration=0.7)
CARTESIAN_PACE = Pace(velocity=0.2, acceleration=0.5)


class PlanningTask:
    """The state of one planning problem.

    Attributes:
        robot: The robot, with what it carries, where it stands.
        space: Its free coordinates; curves run through them.
        scene: The request's, with margins that the start keeps.
        planner: Of paths in that scene.
        x_start: Where a plan begins, shape (size,).
        reasons: How many candidates failed for which reason so far.
        considered: How many candidates were looked at so far.
    """

    def __init__(
        self,
        model: RobotModel,
        request: Request[object],
        reserve_m: float,
        own_m: float = SELF_MARGIN_M,
        start_reserve_m: float | None = None,
    ) -> None:
        """Begin with a request.

        Args:
            model: The robot.
            request: What is asked.
            reserve_m: Kept in reserve against the checker, beyond the scene's margins.
            own_m: Kept between the robot's own links.
            start_reserve_m: What the start's margins are lowered for; ``reserve_m`` when left out.
        """
        self.robot = StandingRobot.of(model, request.stance)
        self.space = free_coordinates(self.robot)
        self._model, self._asked, self._reserve_m, self._own_m = model, request, reserve_m, own_m
        start_m = reserve_m if start_reserve_m is None else start_reserve_m
        self.scene = relaxed_at(model, request.scene, request.q_start, start_m)
        self.planner = self.planner_in(self.scene)
        self.x_start = self.space.start(request.q_start)
        self.reasons: Counter[str] = Counter()
        self.considered = 0

    def tried(self, candidate: C, plan_of: Callable[[C], P | str]) -> P | None:
        """The plan for a candidate, or None with the reason counted.

        Args:
            candidate: One of those that may do.
            plan_of: Gives its plan, or why there is none.
        """
        self.considered += 1
        plan = plan_of(candidate)
        if isinstance(plan, str):
            self.reasons[plan] += 1
            return None
        return plan

    def planner_in(
        self, scene: PlanningScene, like: PathPlanner | None = None, reserve_m: float | None = None
    ) -> PathPlanner:
        """A planner of paths in another scene.

        Args:
            scene: Made of this task's.
            like: One of a scene that differs in what may touch alone; its memory is used.
            reserve_m: Kept in reserve against the checker; the task's when left out.
        """
        before = None if like is None else like.judge
        reserve_m = self._reserve_m if reserve_m is None else reserve_m
        return PathPlanner(
            self._model, self.space, validity(self.robot, scene, reserve_m, self._own_m, before)
        )

    def ik_of(self, hand: Hand) -> InverseKinematics:
        """The inverse kinematics of a hand."""
        return inverse_kinematics(self.robot, hand)

    @property
    def lowest_m(self) -> float:
        """How low the base may come: farther down, whoever watches takes it for falling."""
        welded = self._model.description.welded
        return -np.inf if welded else CROUCHED_SHARE * float(self.robot.q_home[2])

    def stays_up(self, *configurations: Array) -> bool:
        """Whether the motors hold configurations, shape (nq,) each, and none is taken for a fall."""
        dynamics, most = self.robot.derived(StandingDynamics), BORNE_SHARE * self._model.effort
        return all(
            self.stands(q) and bool(np.all(np.abs(dynamics.holding_efforts(q)) <= most))
            for q in configurations
        )

    def stands(self, q: Array) -> bool:
        """Whether nobody takes it for falling; a welded base stays as it is bolted, be it to a ceiling."""
        up = 1.0 - 2.0 * float(q[3] ** 2 + q[4] ** 2)
        upright = bool(q[2] >= self.lowest_m - _ROUNDING_M) and up >= math.cos(LEANING_RAD)
        return self._model.description.welded or upright

    def bears(self, trajectory: Trajectory) -> bool:
        """Whether the motors can carry a motion out."""
        dynamics, most = self.robot.derived(StandingDynamics), BORNE_SHARE * self._model.effort
        q, v, t_s = trajectory.q, trajectory.v, trajectory.t_s
        for k in range(1, len(t_s) - 1, _EVERY):
            acceleration = (v[k + 1] - v[k - 1]) / (t_s[k + 1] - t_s[k - 1])
            if np.any(np.abs(dynamics.efforts(q[k], v[k], acceleration)) > most):
                return False
        return True

    def rows(self, configurations: Iterable[Array]) -> Array:
        """Free coordinates of n configurations, shape (nq,) each, as rows of shape (n, size)."""
        return np.array([self.space.from_q(q) for q in configurations])

    def looking(self, x: Array, gaze: Mapping[str, float]) -> Array:
        """Free coordinates, shape (n, size), with joints of the head as a gaze has them; changed in place."""
        for joint, angle in gaze.items():
            x[:, self.space.index(joint)] = angle
        return x

    def path(self, x_goal: Array, arms: Iterable[Hand], rng: np.random.Generator) -> Curve | None:
        """A free way from the start to a goal, shape (size,), for which arms and trunk may leave the line."""
        groups = self._model.description.groups
        joints = [joint for hand in arms for joint in groups[f"{hand}_arm"]]
        moving = [self.space.index(joint) for joint in (*joints, *groups["torso"])]
        return self.planner.plan(self.x_start, x_goal, moving, rng)

    def straight(self, x_goal: Array) -> Curve | None:
        """The straight way from the start to a goal, shape (size,), if it is free."""
        return self.planner.straight(self.x_start, x_goal)

    def first_step(self, name: str, curve: Curve, pace: Pace) -> PlannedStep | None:
        """Give the way from the start its time; None when the legs cannot follow, or the robot would tip.

        What is too near to the start already may be as near as that.
        """
        step = self.step(name, curve, pace, self.start_concessions(name))
        if step is None:
            return None
        led = lead_in(step.trajectory, self._asked.q_start, self._model.acceleration)
        return dataclasses.replace(step, trajectory=led)

    def step(
        self,
        name: str,
        curve: Curve,
        pace: Pace,
        concessions: tuple[Concession, ...] = (),
        scene: PlanningScene | None = None,
    ) -> PlannedStep | None:
        """Give a curve its time, to be judged in a scene; in the request's when that is left out.

        Returns:
            None when the legs cannot follow, or the robot would tip at any pace.
        """
        trajectory = time_in_balance(self.robot, curve, pace)
        if trajectory is None:
            return None
        return PlannedStep(name, trajectory, self._asked.scene if scene is None else scene, concessions)

    def start_concessions(self, step: str) -> tuple[Concession, ...]:
        """What may be as near as it is at the start, in a step."""
        asked = self._asked
        return start_concessions(self._model, asked.scene, self.scene, asked.q_start, step)
