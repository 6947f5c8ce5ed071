"""One door to all planning and checking: a request in, an answer out.

Both are frozen values, so that the same planner serves inline and in a worker process.
"""

from __future__ import annotations

from kinematics.gesture_planner import GesturePlanner
from kinematics.handle_planner import HandlePlanner
from kinematics.move_planner import plan_move
from kinematics.pick_planner import PickPlanner
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
    PlanRequest,
    RetreatRequest,
)
from kinematics.retreat_planner import plan_retreat
from kinematics.robot_model import RobotModel
from kinematics.trajectory import CheckedTrajectory, Unsafe
from kinematics.trajectory_check import TrajectoryChecker
from kinematics.view_planner import ViewPlanner
from kinematics.view_request import ViewRequest

Answer = PickPlan | MovePlan | HandlePlan | PlacePlan | NoPlan | CheckedTrajectory | Unsafe


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
            return plan_move(self._model, request)
        if isinstance(request, RetreatRequest):
            return plan_retreat(self._model, request)
        if isinstance(request, HandleRequest):
            return self._handle.plan(request)
        if isinstance(request, PlaceRequest):
            return self._place.plan(request)
        if isinstance(request, ViewRequest):
            return self._view.plan(request)
        if isinstance(request, CheckRequest):
            return self._checker.check(request.trajectory, request.scene, request.concessions)
        return self._gestures.plan(request)
