"""Postures of an arm, and perhaps the trunk, that meet a few conditions; the feet and the base stay.

Damped Gauss-Newton on residuals with a numeric Jacobian (Levenberg 1944, Marquardt 1963): a handful of
joints, so that anything that forward kinematics can tell may be asked for.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.robot_model import RobotModel

Array = NDArray[np.float64]
Residual = Callable[[Array], Array]
"""Maps a configuration, shape (nq,), to what should be zero; metres and radians alike."""

ITERATIONS = 40
# A step that gains less than this share of the cost ends the search; so does a cost like this.
SETTLED = 0.01
ENOUGH = 1e-5
STEP_RAD = 1e-5
# How strongly a posture is drawn to the preferred one, against the conditions.
PULL = 0.01
_LONGEST_STEP_RAD = 0.4


@dataclass(frozen=True, slots=True)
class ArmPosture:
    """One answer.

    Attributes:
        q: Configuration, shape (nq,); only the asked joints differ from the start's.
        error: Norm of the residual, without the pull.
    """

    q: Array
    error: float


def arm_posture(
    model: RobotModel, q_start: Array, joints: Sequence[str], residual: Residual, preferred: Array
) -> ArmPosture:
    """Search the posture of some joints that makes a residual vanish, inside the planning limits.

    Args:
        model: The robot.
        q_start: Where the search begins and what the other joints keep, shape (nq,).
        joints: Joints that may move.
        residual: What should be zero.
        preferred: Their positions where there is a choice, rad, shape (len(joints),).
    """
    columns = 7 + model.indices(joints)
    margin = model.description.planning_margin_rad
    lower, upper = model.lower_rad[columns - 7] + margin, model.upper_rad[columns - 7] - margin
    q = q_start.copy()
    q[columns] = np.clip(q[columns], lower, upper)
    damping, pull = 1e-3, PULL
    cost, r = _cost(q, columns, residual, preferred, pull)
    for _ in range(ITERATIONS):
        jacobian = np.empty((len(r), len(columns)))
        for k, column in enumerate(columns):
            moved = q.copy()
            moved[column] += STEP_RAD
            jacobian[:, k] = (_stacked(moved, columns, residual, preferred, pull) - r) / STEP_RAD
        # joints at a limit that want beyond it are held
        gradient = jacobian.T @ r
        at_limit = ((q[columns] <= lower) & (gradient > 0.0)) | ((q[columns] >= upper) & (gradient < 0.0))
        jacobian[:, at_limit] = 0.0
        step = -np.linalg.solve(
            jacobian.T @ jacobian + damping * np.eye(len(columns)), np.where(at_limit, 0.0, gradient)
        )
        longest = float(np.abs(step).max())
        step *= min(1.0, _LONGEST_STEP_RAD / max(longest, 1e-12))
        trial = q.copy()
        trial[columns] = np.clip(q[columns] + step, lower, upper)
        trial_cost, trial_r = _cost(trial, columns, residual, preferred, pull)
        if trial_cost < cost:
            settled = cost - trial_cost < SETTLED * cost
            q, cost, r, damping = trial, trial_cost, trial_r, max(damping * 0.2, 1e-7)
            if settled or cost < ENOUGH:
                break
        else:
            damping *= 10.0
            if damping > 1e3:
                break
    return ArmPosture(q, float(np.linalg.norm(residual(q))))


def _stacked(q: Array, columns: NDArray[np.intp], residual: Residual, preferred: Array, pull: float) -> Array:
    return np.concatenate([residual(q), pull * (q[columns] - preferred)])


def _cost(
    q: Array, columns: NDArray[np.intp], residual: Residual, preferred: Array, pull: float
) -> tuple[float, Array]:
    stacked = _stacked(q, columns, residual, preferred, pull)
    return float(stacked @ stacked), stacked
