"""Whether the body is where it was told to go, from its own encoders."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from py_trees.common import Status

from kinematics.model.robot_model import RobotModel
from kinematics.motion.verdict import CheckedTrajectory
from trees.failures import Failure, Reason
from trees.nodes.leaf import DONE, RUNNING, Leaf
from trees.toolbox import Toolbox

_HOME_RAD = 0.01
"""A reference nearer than this to home is home."""


def largest_error(
    model: RobotModel, q: NDArray[np.float64], q_goal: NDArray[np.float64]
) -> tuple[str, float]:
    """The joint that is farthest from its goal, and by how much in rad; ``q`` have shape (nq,).

    The base is left out: it follows from the joints and the stance, and is only estimated.
    """
    error = np.abs(q[7:] - q_goal[7:])
    worst = int(np.argmax(error))
    return model.joints[worst], float(error[worst])


def is_told_to_be_home(toolbox: Toolbox) -> bool:
    """Whether every body joint is commanded to be at home, where no way home could meet anything."""
    model = toolbox.model
    return largest_error(model, toolbox.motion.reference(), model.q_home)[1] <= _HOME_RAD


def arrival(leaf: Leaf, checked: CheckedTrajectory, by_s: float) -> Status | Failure:
    """After a motion is done: ``RUNNING`` while the joints settle, then success or who did not follow."""
    toolbox = leaf.toolbox
    tolerance = toolbox.policy.arrival_tolerance_rad
    joint, error = largest_error(toolbox.model, toolbox.sensing.state().q, checked.trajectory.q[-1])
    if error <= tolerance:
        return DONE
    if leaf.elapsed_s < by_s:
        return RUNNING
    return Failure.execution(
        f"{joint} did not follow {leaf.name} to its end",
        joint=joint,
        error_rad=error,
        tolerance_rad=tolerance,
    ).because(Reason.NOT_FOLLOWED)
