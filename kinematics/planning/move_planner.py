"""Plan a motion to a posture: far from things where there is room, and as near as is allowed where not."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array
from kinematics.collision.relaxed_start import (
    relaxed_at,
    rest_concessions,
    start_concessions,
    touching_at_rest,
)
from kinematics.collision.validity import Validity, validity
from kinematics.collision.wide_berth import wide_berth
from kinematics.model.robot_model import RobotModel
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.curves import Curve
from kinematics.motion.lead_in import lead_in
from kinematics.planning.held_lean import MOST_LEAN_RAD, leaned_rad, least_leaning
from kinematics.planning.path_planner import PathPlanner, PathSettings
from kinematics.planning.planning_task import REACH_PACE
from kinematics.requests.move import MovePlan, MoveRequest
from kinematics.requests.step import NoPlan, PlannedStep
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing.free_coordinates import FreeCoordinates, free_coordinates
from kinematics.standing.reserves import MOVING_RESERVE_M as RESERVE_M
from kinematics.timing.balanced_timing import time_in_balance

_PATIENT = PathSettings(iterations=10_000)
"""A move has one goal, and no other to turn to. Of 40 ways out of boxes around the hand 7 are found with 300,
34 with 3,000, and all with these."""


@dataclass(frozen=True, slots=True)
class _Ends:
    """Start and goal in free coordinates, shape (size,) each."""

    space: FreeCoordinates
    start: Array
    goal: Array


def plan_move(model: RobotModel, request: MoveRequest) -> MovePlan | NoPlan:
    """Plan it, or say why there is none."""
    robot = StandingRobot.of(model, request.stance)
    space = free_coordinates(robot)
    start = space.start(request.q_start)
    ends = _Ends(space, start, _goal(robot, start, request))
    scene = relaxed_at(model, request.scene, request.q_start)
    concessions = start_concessions(model, request.scene, scene, request.q_start, "move")
    way = _way(robot, request, ends, scene)
    if way is None:
        q_goal = space.to_q(ends.goal[None, :])[0][0]
        resting = touching_at_rest(model, scene, request.q_start, q_goal)
        curve = PathPlanner(model, space, validity(robot, resting)).straight(start, ends.goal)
        if curve is None:
            return _no_way(validity(robot, scene), ends)
        concessions += rest_concessions(scene, resting, "move")
        way = leaned_rad(model, space, curve, scene), curve
    lean_rad, curve = way
    if request.level and lean_rad > MOST_LEAN_RAD:
        return NoPlan("what a hand holds would lean on the way", {"what is held leans": 1})
    trajectory = time_in_balance(robot, curve, REACH_PACE)
    if trajectory is None:
        return NoPlan("the legs cannot follow the motion", {"legs cannot follow": 1})
    trajectory = lead_in(trajectory, request.q_start, model.acceleration)
    return MovePlan(PlannedStep("move", trajectory, request.scene, concessions))


def _goal(robot: StandingRobot, start: Array, request: MoveRequest) -> Array:
    space, goal = free_coordinates(robot), start.copy()
    if not request.keep_others:
        goal = space.from_q(robot.q_home)
    for joint, angle in request.joints.items():
        goal[space.index(joint)] = angle
    if space.base_size:
        goal[:3] += request.pelvis_m
    return goal


def _way(
    robot: StandingRobot, request: MoveRequest, ends: _Ends, scene: PlanningScene
) -> tuple[float, Curve] | None:
    """A free curve: with a wide berth of things, else with a reserve against the checker, else without.

    What a hand holds leans little on it, if that costs no more than some of the berth: how far comes first.
    """
    model, groups = robot.model, robot.model.description.groups
    moving = [
        ends.space.index(joint) for name in ("left_arm", "right_arm", "torso") for joint in groups[name]
    ]
    spare = relaxed_at(model, request.scene, request.q_start, RESERVE_M)
    wide = wide_berth(model, spare, request.q_start, RESERVE_M)
    ways = [(spare, RESERVE_M, PathSettings()), (scene, 0.0, _PATIENT)]
    if wide is not spare:
        ways.insert(0, (wide, RESERVE_M, PathSettings()))
    found: list[tuple[float, Curve]] = []
    for around, reserve_m, settings in ways:
        judge = validity(robot, around, reserve_m)
        planner = PathPlanner(model, ends.space, judge, settings)
        curve = planner.plan(ends.start, ends.goal, moving, np.random.default_rng(request.seed))
        if curve is not None:
            found.append(least_leaning(planner, model, ends.space, curve, scene))
            if found[-1][0] <= MOST_LEAN_RAD:
                break
    return min(found, key=lambda one: one[0], default=None)


def _no_way(judge: Validity, ends: _Ends) -> NoPlan:
    """What bars goal or start, if anything does."""
    reason = judge.why_not(ends.goal) or judge.why_not(ends.start) or "no collision-free path"
    return NoPlan(f"no motion to the posture was found: {reason}", {reason: 1})
