"""Platt's map from a raw confidence to a calibrated one: p = 1 / (1 + exp(-(slope x + offset)))."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from kinematics.arrays import Array
from tools.calibration.answers import Answer
from trees.skills.telling.telling_leaf import log_odds

_STEPS = 100
_RIDGE = 1.0
"""As much as a few answers: few answers, or all right, do not bend the line far from "as it is"."""
_PRIOR = np.array([1.0, 0.0])
_CLOSE = 1e-9


def fitted(answers: Sequence[Answer]) -> tuple[float, float]:
    """Slope and offset by Newton's method on the log-likelihood, with Platt's (1999) softened targets.

    x is the log-odds of the raw confidence.
    """
    x = np.array([log_odds(answer.raw) for answer in answers])
    right = np.array([answer.right for answer in answers])
    yes, no = int(right.sum()), int((~right).sum())
    target = np.where(right, (yes + 1.0) / (yes + 2.0), 1.0 / (no + 2.0))
    A = np.column_stack([x, np.ones_like(x)])
    w, best = _PRIOR.copy(), np.inf
    for _ in range(_STEPS):
        p = 1.0 / (1.0 + np.exp(-A @ w))
        gradient = A.T @ (p - target) + _RIDGE * (w - _PRIOR)
        curvature = (A * (p * (1.0 - p))[:, None]).T @ A + _RIDGE * np.eye(2)
        step = np.linalg.solve(curvature, gradient)
        while (cost := _cost(w - step, A, target)) > best and float(np.abs(step).max()) > _CLOSE:
            step = 0.5 * step
        if float(np.abs(step).max()) <= _CLOSE:
            break
        w, best = w - step, cost
    return float(w[0]), float(w[1])


def _cost(w: Array, A: Array, target: Array) -> float:
    """Negative log-likelihood, shape (2,), (n, 2), (n,), with the pull to the prior."""
    z = A @ w
    losses = np.logaddexp(0.0, z) - target * z
    return float(losses.sum() + 0.5 * _RIDGE * np.sum((w - _PRIOR) ** 2))
