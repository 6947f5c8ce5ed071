"""Planning for a served robot, beside the executive: a request in, an answer out, and what it took."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Generic, TypeVar

from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.formats.trajectory_document import write_trajectory
from kinematics.formats.trajectory_fit import stored_from
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.motion.verdict import CheckedTrajectory, Unsafe
from kinematics.motion_planner import MotionPlanner
from kinematics.requests.check import CheckRequest
from kinematics.requests.move import MovePlan, MoveRequest
from kinematics.requests.request import Request
from kinematics.scene.planning_scene import PlanningScene
from robots.clock import WallClock
from robots.models.description import load_description

Answer = TypeVar("Answer", covariant=True)


@dataclass(frozen=True, slots=True)
class Planned(Generic[Answer]):
    """An answer; ``document`` is a checked trajectory with its scene as text, for the other checker."""

    answer: Answer
    wall_s: float
    document: str = ""


class PlanningService:
    """Answers requests for one robot."""

    def __init__(self, robot: str) -> None:
        """Load the robot."""
        self._model = RobotModel(load_description(robot))
        self._planner, self._checker = MotionPlanner(self._model), TrajectoryChecker(self._model)
        self._warm_up()

    def _warm_up(self) -> None:
        """Load now what the first plan would wait for: libraries and compiled code."""
        q = self._model.q_home
        joint = self._model.joints[-1]
        wanted = {joint: float(q[7 + self._model.joint_index(joint)]) - 0.05}
        planned = self._planner.answer(MoveRequest(q, stance_at(self._model, q), PlanningScene(), wanted))
        if isinstance(planned, MovePlan):
            self._judged(planned.step.question)

    def answer(self, asked: Request[object] | CheckRequest) -> Planned[object]:
        """Plan or check: both come by one pipe."""
        wall = WallClock()
        if isinstance(asked, CheckRequest):
            verdict = self._judged(asked)
            safe = isinstance(verdict, CheckedTrajectory)
            document = write_trajectory(stored_from(asked, self._model)) if safe else ""
            return Planned(verdict, wall.now_s(), document)
        return Planned(self._planner.answer(asked), wall.now_s())

    def _judged(self, question: CheckRequest) -> CheckedTrajectory | Unsafe:
        return self._checker.check(question.trajectory, question.scene, question.concessions)
