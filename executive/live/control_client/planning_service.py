"""Planning for a served robot, beside the executive: a request in, an answer out, and what it took."""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.formats.trajectory_document import write_trajectory
from kinematics.formats.trajectory_fit import stored_from
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.motion.verdict import CheckedTrajectory
from kinematics.motion_planner import Answer, MotionPlanner
from kinematics.requests.any_request import PlanRequest
from kinematics.requests.check import CheckRequest
from kinematics.requests.move import MovePlan, MoveRequest
from kinematics.scene.planning_scene import PlanningScene
from robots.clock import WallClock
from robots.models.description import load_description


@dataclass(frozen=True, slots=True)
class Planned:
    """An answer; ``document`` is a checked trajectory with its scene as text, for the other checker."""

    answer: Answer
    wall_s: float
    document: str = ""


class PlanningService:
    """Answers requests for one robot."""

    def __init__(self, robot: str) -> None:
        """Load the robot."""
        self._model = RobotModel(load_description(robot))
        self._planner = MotionPlanner(self._model)
        self._warm_up()

    def _warm_up(self) -> None:
        """Load now what the first plan would wait for: libraries and compiled code."""
        q = self._model.q_home
        joint = self._model.joints[-1]
        wanted = {joint: float(q[7 + self._model.joint_index(joint)]) - 0.05}
        planned = self._planner.answer(MoveRequest(q, stance_at(self._model, q), PlanningScene(), wanted))
        if isinstance(planned, MovePlan):
            self._planner.answer(planned.step.question)

    def answer(self, request: PlanRequest) -> Planned:
        """Plan or check."""
        wall = WallClock()
        answer = self._planner.answer(request)
        document = ""
        if isinstance(request, CheckRequest) and isinstance(answer, CheckedTrajectory):
            document = write_trajectory(stored_from(request, self._model))
        return Planned(answer, wall.now_s(), document)
