"""One door to all planning: a request in, an answer of its type out.

Both are frozen values, so that the same planner serves inline and in a worker process. Judging trajectories
is no planning: ``TrajectoryChecker`` is the door to that.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any, TypeVar

from kinematics.dynamics.held_load import loaded, loads_in
from kinematics.model.robot_model import RobotModel
from kinematics.motion.trajectory import HeldLoad
from kinematics.planning.control_planner import ControlPlanner
from kinematics.planning.gesture_planner import GesturePlanner
from kinematics.planning.handle_planner import HandlePlanner
from kinematics.planning.move_planner import plan_move
from kinematics.planning.pick_planner import PickPlanner
from kinematics.planning.place_planner import PlacePlanner
from kinematics.planning.retreat_planner import plan_retreat
from kinematics.planning.view_planner import ViewPlanner
from kinematics.requests.control import ControlRequest, TurnRequest
from kinematics.requests.handle import HandleRequest
from kinematics.requests.move import MoveRequest, RetreatRequest
from kinematics.requests.pick import PickRequest
from kinematics.requests.place import PlaceRequest
from kinematics.requests.request import Request
from kinematics.requests.view import ViewRequest

Answer = TypeVar("Answer")

Planners = Mapping[type[Request[Any]], Callable[[Any], Any]]
"""Who answers which requests; each takes its kind of request, and answers as that says."""


def planners(model: RobotModel) -> Planners:
    """The planners of a robot with what its hands carry."""
    return {
        PickRequest: PickPlanner(model).plan,
        PlaceRequest: PlacePlanner(model).plan,
        HandleRequest: HandlePlanner(model).plan,
        ControlRequest: ControlPlanner(model).plan,
        TurnRequest: ControlPlanner(model).plan_turn,
        ViewRequest: ViewPlanner(model).plan,
        MoveRequest: partial(plan_move, model),
        RetreatRequest: partial(plan_retreat, model),
        **GesturePlanner(model).planners,
    }


class MotionPlanner:
    """Answers every request for a plan of one robot.

    What a request says that the hands carry, and how heavy that is, counts as part of the robot when balance
    is planned; nothing else of a request is kept for the next.
    """

    def __init__(self, model: RobotModel) -> None:
        self._model = model
        self._planners = planners(model)
        self._carrying: tuple[tuple[HeldLoad, ...], Planners] = ((), self._planners)

    def answer(self, request: Request[Answer]) -> Answer:
        """Answer any request.

        Raises:
            TypeError: It is no request that a planner answers.
        """
        plan = self._with(loads_in(request.scene)).get(type(request))
        if plan is None:
            known = ", ".join(sorted(kind.__name__ for kind in self._planners))
            raise TypeError(f"no planner answers a {type(request).__name__}; requests are {known}")
        answer: Answer = plan(request)
        return answer

    def _with(self, loads: tuple[HeldLoad, ...]) -> Planners:
        if not loads:
            return self._planners
        if self._carrying[0] != loads:
            self._carrying = loads, planners(loaded(self._model, loads))
        return self._carrying[1]
