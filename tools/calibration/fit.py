"""Platt's map from a raw confidence to a calibrated one: p = 1 / (1 + exp(-(slope x + offset)))."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tools.calibration.answers import Answer
from trees.stated_confidence import log_odds

_STEPS = 100
_RIDGE = 1e-3
"""Keeps the slope finite where everything is right."""


def fitted(answers: Sequence[Answer]) -> tuple[float, float]:
    """Slope and offset by Newton's method on the log-likelihood, with Platt's (1999) softened targets.

    x is the log-odds of the raw confidence.
    """
    x = np.array([log_odds(answer.raw) for answer in answers])
    right = np.array([answer.right for answer in answers])
    yes, no = int(right.sum()), int((~right).sum())
    target = np.where(right, (yes + 1.0) / (yes + 2.0), 1.0 / (no + 2.0))
    A = np.column_stack([x, np.ones_like(x)])
    w = np.array([1.0, 0.0])
    for _ in range(_STEPS):
        p = 1.0 / (1.0 + np.exp(-A @ w))
        H = (A * (p * (1.0 - p))[:, None]).T @ A + _RIDGE * np.eye(2)
        step = np.linalg.solve(H, A.T @ (p - target) + _RIDGE * (w - (1.0, 0.0)))
        w = w - step
        if float(np.abs(step).max()) < 1e-9:
            break
    return float(w[0]), float(w[1])
