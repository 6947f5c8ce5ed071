"""One door to all planning and checking: a request in, an answer out.

Both are frozen values, so that the same planner serves inline and in a worker process.
"""

from __future__ import annotations

from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.dynamics.held_load import loaded, loads_in
from kinematics.model.robot_model import RobotModel
from kinematics.motion.trajectory import HeldLoad
from kinematics.motion.verdict import CheckedTrajectory, Unsafe
from kinematics.planning.gesture_planner import GesturePlanner
from kinematics.planning.handle_planner import HandlePlanner
from kinematics.planning.move_planner import plan_move
from kinematics.planning.pick_planner import PickPlanner
from kinematics.planning.place_planner import PlacePlanner
from kinematics.planning.retreat_planner import plan_retreat
from kinematics.planning.view_planner import ViewPlanner
from kinematics.requests.any_request import PlanRequest
from kinematics.requests.check import CheckRequest
from kinematics.requests.handle import HandlePlan, HandleRequest
from kinematics.requests.move import MovePlan, MoveRequest, RetreatRequest
from kinematics.requests.pick import PickPlan, PickRequest
from kinematics.requests.place import PlacePlan, PlaceRequest
from kinematics.requests.step import NoPlan
from kinematics.requests.view import ViewRequest

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
