"""The control side's own checker, in a process of its own: ``python -m
robots.live.process.admission_process``.

It reads a stored trajectory with the scene that it was made for, as text, and judges it anew; what the
other side believes of it plays no part.
"""

from __future__ import annotations

import sys

from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.errors import KinematicsError
from kinematics.formats.trajectory_document import read_trajectory
from kinematics.formats.trajectory_fit import fit
from kinematics.model.robot_model import RobotModel
from kinematics.motion.verdict import CheckedTrajectory, Unsafe
from kinematics.scene.planning_scene import PlanningScene
from robots.live.wire.child_process import serve_parent
from robots.models.description import load_description


class Admission:
    """Judges documents for one robot."""

    def __init__(self, robot: str) -> None:
        """Load the robot."""
        self._model = RobotModel(load_description(robot))
        self._checker = TrajectoryChecker(self._model)

    def judge(self, document: bytes) -> CheckedTrajectory | Unsafe | str:
        """The checked trajectory, what is unsafe about it, or why it is none of this robot's."""
        try:
            stored = read_trajectory(document.decode("utf-8"))
            if stored.objects is None:
                return "the document does not say what is around"
            asked = fit(stored, self._model, PlanningScene().with_objects(stored.objects))
            return self._checker.check(asked.trajectory, asked.scene, asked.concessions)
        except UnicodeDecodeError:
            return "the document is not UTF-8 text"
        except KinematicsError as unfit:
            return str(unfit)


def main() -> None:
    """Serve the parent whose pipe is the last argument."""
    robot, descriptor = sys.argv[1], int(sys.argv[2])
    serve_parent(descriptor, Admission(robot).judge)


if __name__ == "__main__":
    main()
