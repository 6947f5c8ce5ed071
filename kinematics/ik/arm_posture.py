"""Postures of an arm, and perhaps the trunk, that meet a few conditions; the feet and the base stay.

Damped Gauss-Newton on residuals with a numeric Jacobian (Levenberg 1944, Marquardt 1963): a handful of
joints, so that anything that the places of an arm's parts can tell may be asked for.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array, Sealed
from kinematics.ik.arm_frames import ArmFrames, ArmKinematics
from kinematics.model.robot_model import RobotModel

Residual = Callable[[ArmFrames], Array]
"""Maps n rows of places to what should be zero, shape (n, m); metres and radians alike."""

ITERATIONS = 40
# A step that gains less than this share of the cost ends the search; so does a cost like this.
SETTLED = 0.01
ENOUGH = 1e-5
STEP_RAD = 1e-5
# How strongly a posture is drawn to the preferred one, against the conditions.
PULL = 0.01
_LONGEST_STEP_RAD = 0.6
# The pull damps by its own square: with less than this beside it, many steps are tried in vain.
_LEAST_DAMPING = 1e-4


@dataclass(frozen=True, slots=True)
class ArmPosture(Sealed):
    """The posture at which a search ended; ``error`` says whether it meets what was asked for.

    Attributes:
        q: Configuration, shape (nq,); only the arm's joints and the trunk's turn differ from the start's.
        error: Norm of the residual there; the pull to the preferred posture is not counted.
    """

    q: Array
    error: float


def arm_posture(
    model: RobotModel, arm: ArmKinematics, q_start: Array, residual: Residual, preferred: Array
) -> ArmPosture:
    """Search the posture of an arm's joints that makes a residual vanish, inside the planning limits.

    Args:
        model: The robot.
        arm: What moves.
        q_start: Where the search begins and what the other joints keep, shape (nq,).
        residual: What should be zero.
        preferred: The joints' positions where there is a choice, rad, shape (k,).
    """
    columns = arm.columns
    margin = model.description.planning_margin_rad
    lower, upper = model.lower_rad[columns - 7] + margin, model.upper_rad[columns - 7] - margin
    search = _Search(arm, residual, preferred)
    q = q_start.copy()
    q[columns] = np.clip(q[columns], lower, upper)
    damping = 1e-3
    cost, r, jacobian = search.around(q)
    for _ in range(ITERATIONS):
        # joints at a limit that want beyond it are held
        gradient = jacobian.T @ r
        at_limit = ((q[columns] <= lower) & (gradient > 0.0)) | ((q[columns] >= upper) & (gradient < 0.0))
        free = np.where(at_limit, 0.0, jacobian)
        step = -np.linalg.solve(
            free.T @ free + damping * np.eye(len(columns)), np.where(at_limit, 0.0, gradient)
        )
        longest = float(np.abs(step).max())
        step *= min(1.0, _LONGEST_STEP_RAD / max(longest, 1e-12))
        trial = q.copy()
        trial[columns] = np.clip(q[columns] + step, lower, upper)
        trial_cost, trial_r, trial_jacobian = search.around(trial)
        if trial_cost < cost:
            settled = cost - trial_cost < SETTLED * cost
            q, cost, r, jacobian = trial, trial_cost, trial_r, trial_jacobian
            damping = max(damping * 0.2, _LEAST_DAMPING)
            if settled or cost < ENOUGH:
                break
        else:
            damping *= 10.0
            if damping > 1e3:
                break
    return ArmPosture(q, float(np.linalg.norm(r[: -len(columns)])))


@dataclass(frozen=True, slots=True)
class _Search:
    """What a search asks of each posture; see ``arm_posture``."""

    arm: ArmKinematics
    residual: Residual
    preferred: Array

    def around(self, q: Array) -> tuple[float, Array, Array]:
        """Cost, residual with the pull, shape (m + k,), and its Jacobian, shape (m + k, k)."""
        rows = self.residual(self.arm.around(q, STEP_RAD))
        pull = PULL * (q[self.arm.columns] - self.preferred)
        r = np.concatenate([rows[0], pull])
        jacobian = np.concatenate([(rows[1:] - rows[0]).T / STEP_RAD, PULL * np.eye(len(pull))])
        return float(r @ r), r, jacobian
