"""One door to all planning and checking: a request in, an answer out.

Both are frozen values, so that the same planner serves inline and in a worker process.
"""

from __future__ import annotations

import numpy as np

from kinematics.balanced_timing import time_in_balance
from kinematics.collision import CollisionWorld
from kinematics.free_coordinates import free_coordinates
from kinematics.gesture_planner import GesturePlanner
from kinematics.gesture_task import RESERVE_M
from kinematics.handle_planner import HandlePlanner
from kinematics.lead_in import lead_in
from kinematics.path_planner import PathPlanner, PathSettings
from kinematics.pick_planner import PickPlanner
from kinematics.pick_task import REACH_PACE
from kinematics.place_planner import PlacePlanner
from kinematics.place_requests import PlaceRequest
from kinematics.requests import (
    CheckRequest,
    HandlePlan,
    HandleRequest,
    MovePlan,
    MoveRequest,
    NoPlan,
    PickPlan,
    PickRequest,
    PlacePlan,
    PlannedStep,
    PlanRequest,
    RetreatRequest,
)
from kinematics.retreat_planner import plan_retreat
from kinematics.robot_model import RobotModel
from kinematics.start_state import relaxed_at, touching_at_rest
from kinematics.trajectory import CheckedTrajectory, Unsafe
from kinematics.trajectory_check import TrajectoryChecker
from kinematics.validity import validity
from kinematics.view_planner import ViewPlanner
from kinematics.view_request import ViewRequest
from kinematics.wide_berth import wide_berth

Answer = PickPlan | MovePlan | HandlePlan | PlacePlan | NoPlan | CheckedTrajectory | Unsafe


_PATIENT = PathSettings(iterations=10_000)
"""A move has one goal, and no other to turn to. Of 40 ways out of boxes around the hand 7 are found with 300,
34 with 3,000, and all with these."""


class MotionPlanner:
    """Plans and checks for one robot; holds no state between requests."""

    def __init__(self, model: RobotModel) -> None:
        self._model = model
        self._pick = PickPlanner(model)
        self._gestures = GesturePlanner(model)
        self._place = PlacePlanner(model)
        self._handle = HandlePlanner(model)
        self._view = ViewPlanner(model)
        self._checker = TrajectoryChecker(model)

    def answer(self, request: PlanRequest) -> Answer:
        """Answer any request."""
        if isinstance(request, PickRequest):
            return self._pick.plan(request)
        if isinstance(request, MoveRequest):
            return self._move(request)
        if isinstance(request, RetreatRequest):
            return plan_retreat(self._model, request)
        if isinstance(request, HandleRequest):
            return self._handle.plan(request)
        if isinstance(request, PlaceRequest):
            return self._place.plan(request)
        if isinstance(request, ViewRequest):
            return self._view.plan(request)
        if isinstance(request, CheckRequest):
            return self._checker.check(request.trajectory, request.scene)
        return self._gestures.plan(request)

    def _move(self, request: MoveRequest) -> MovePlan | NoPlan:
        model = self._model
        space = free_coordinates(model, request.stance)
        start = space.from_q(request.q_start)
        goal = start.copy()
        if not request.keep_others:
            goal = space.from_q(model.home_over(request.stance))
        for joint, angle in request.joints.items():
            goal[space.index(joint)] = angle
        if space.base_size:
            goal[:3] += request.pelvis_m
        scene = relaxed_at(model, request.scene, request.q_start)
        spare = relaxed_at(model, request.scene, request.q_start, RESERVE_M)
        arms = [j for hand in ("left", "right") for j in model.description.groups[f"{hand}_arm"]]
        moving = [space.index(joint) for joint in (*arms, *model.description.groups["torso"])]
        curve = None
        for around, reserve_m, settings in (
            (wide_berth(model, spare, request.q_start, RESERVE_M), RESERVE_M, PathSettings()),
            (spare, RESERVE_M, PathSettings()),
            (scene, 0.0, _PATIENT),
        ):
            judge = validity(model, request.stance, around, reserve_m)
            planner = PathPlanner(model, space, judge, settings)
            curve = planner.plan(start, goal, moving, np.random.default_rng(request.seed))
            if curve is not None:
                break
        if curve is None:
            q_goal = space.to_q(goal[None, :])[0][0]
            scene = touching_at_rest(model, scene, request.q_start, q_goal)
            planner = PathPlanner(model, space, validity(model, request.stance, scene))
            curve = planner.straight(start, goal)
        if curve is None:
            world = CollisionWorld(model, scene)
            pair = world.colliding_pair(space.to_q(goal[None, :])[0][0]) or world.colliding_pair(
                request.q_start
            )
            reason = "no collision-free path" if pair is None else f"{pair[0]} collides with {pair[1]}"
            return NoPlan(f"no motion to the posture was found: {reason}", {reason: 1})
        trajectory = time_in_balance(model, space, request.stance, curve, REACH_PACE)
        if trajectory is None:
            return NoPlan("the legs cannot follow the motion", {"legs cannot follow": 1})
        trajectory = lead_in(trajectory, request.q_start, model.acceleration)
        return MovePlan(PlannedStep("move", trajectory, scene))
