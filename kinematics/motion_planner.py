"""One door to all planning and checking: a request in, an answer out.

Both are frozen values, so that the same planner serves inline and in a worker process.
"""

from __future__ import annotations

from kinematics.gesture_planner import GesturePlanner
from kinematics.handle_planner import HandlePlanner
from kinematics.held_load import loaded, loads_in
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
from kinematics.trajectory import CheckedTrajectory, HeldLoad, Unsafe
from kinematics.trajectory_check import TrajectoryChecker
from kinematics.view_planner import ViewPlanner
from kinematics.view_request import ViewRequest

Answer = PickPlan | MovePlan | HandlePlan | PlacePlan | NoPlan | CheckedTrajectory | Unsafe


class _Planners:
    """The planners of a robot with what its hands carry."""

    def __init__(self, model: RobotModel) -> None:
        self._model = model
        self._pick = PickPlanner(model)
        self._gestures = GesturePlanner(model)
        self._place = PlacePlanner(model)
        self._handle = HandlePlanner(model)
        self._view = ViewPlanner(model)

    def answer(self, request: PlanRequest, checker: TrajectoryChecker) -> Answer:
        """Answer any request; the checker sees itself what the hands carry."""
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
            return checker.check(request.trajectory, request.scene, request.concessions)
        return self._gestures.plan(request)


class MotionPlanner:
    """Plans and checks for one robot; keeps nothing of a request but what its hands carry in it.

    What is weighed and held is part of the robot: its balance is planned with it.
    """

    def __init__(self, model: RobotModel) -> None:
        self._model = model
        self._planners = _Planners(model)
        self._carrying: tuple[tuple[HeldLoad, ...], _Planners] = ((), self._planners)
        self._checker = TrajectoryChecker(model)

    def answer(self, request: PlanRequest) -> Answer:
        """Answer any request."""
        return self._with(loads_in(request.scene)).answer(request, self._checker)

    def _with(self, loads: tuple[HeldLoad, ...]) -> _Planners:
        if not loads:
            return self._planners
        if self._carrying[0] != loads:
            self._carrying = loads, _Planners(loaded(self._model, loads))
        return self._carrying[1]
