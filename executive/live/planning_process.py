"""Planning for a served robot, in a process of its own: ``python -m executive.live.planning_process``."""

from __future__ import annotations

import sys
from dataclasses import dataclass

from kinematics.motion_planner import Answer, MotionPlanner
from kinematics.requests import CheckRequest, PlanRequest
from kinematics.robot_model import RobotModel
from kinematics.trajectory import CheckedTrajectory
from kinematics.trajectory_document import write_trajectory
from kinematics.trajectory_fit import stored_from
from robots.clock import WallClock
from robots.description import load_description
from robots.live.child_process import serve_parent


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

    def answer(self, request: PlanRequest) -> Planned:
        """Plan or check."""
        wall = WallClock()
        answer = self._planner.answer(request)
        document = ""
        if isinstance(request, CheckRequest) and isinstance(answer, CheckedTrajectory):
            document = write_trajectory(stored_from(request, self._model))
        return Planned(answer, wall.now_s(), document)


def main() -> None:
    """Serve the parent whose pipe is the last argument."""
    serve_parent(int(sys.argv[2]), PlanningService(sys.argv[1]).answer)


if __name__ == "__main__":
    main()
