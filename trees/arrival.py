"""Whether the body is where it was told to go, from its own encoders."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.robot_model import RobotModel
from trees.failures import Failure


def largest_error(
    model: RobotModel, q: NDArray[np.float64], q_goal: NDArray[np.float64]
) -> tuple[str, float]:
    """The joint that is farthest from its goal, and by how much in rad; ``q`` have shape (nq,).

    The base is left out: it follows from the joints and the stance, and is only estimated.
    """
    error = np.abs(q[7:] - q_goal[7:])
    worst = int(np.argmax(error))
    return model.joints[worst], float(error[worst])


def not_arrived(motion: str, joint: str, error_rad: float, tolerance_rad: float) -> Failure:
    """The failure of a motion whose end the robot did not reach."""
    return Failure.execution(
        f"{joint} did not follow {motion} to its end",
        joint=joint,
        error_rad=error_rad,
        tolerance_rad=tolerance_rad,
    )
