"""Least squares within bounds, for the few unknowns of one tick of a motion."""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array

_MOST_CHANGES = 60
_NOISE = 1e-9


def boxed_least_squares(normal: Array, right: Array, low: Array, high: Array) -> Array:
    """Minimise ``x @ normal @ x / 2 - right @ x`` within ``low <= x <= high``.

    An active-set method (Nocedal and Wright, Numerical Optimization, 16.5): what meets a bound is fixed
    there, and let go again as soon as it would rather leave the bound inwards. Without the second half,
    whatever left its bounds at first stays fixed at them: a hand stayed 5 cm behind its goal with half of
    its joints free to move.

    Args:
        normal: Symmetric and positive definite, shape (n, n).
        right: Shape (n,).
        low, high: Bounds, shape (n,).

    Returns:
        The minimum, shape (n,); after very many changes, which rounding alone could cause, the best so far.
    """
    x = np.minimum(np.maximum(np.linalg.solve(normal, right), low), high)
    at_low, at_high = x <= low, x >= high
    if not (at_low.any() or at_high.any()):
        return np.asarray(x)
    for _ in range(_MOST_CHANGES):
        free = ~(at_low | at_high)
        if free.any():
            fixed = ~free
            known = right[free] - normal[np.ix_(free, fixed)] @ x[fixed]
            step = np.linalg.solve(normal[np.ix_(free, free)], known) - x[free]
            met = _first_bound(x[free], step, low[free], high[free])
            if met is not None:
                k, share = met
                x[free] += share * step
                where = int(np.flatnonzero(free)[k])
                (at_high if step[k] > 0.0 else at_low)[where] = True
                x[where] = high[where] if step[k] > 0.0 else low[where]
                continue
            x[free] += step
        slope = normal @ x - right
        inwards = np.where(at_low, -slope, np.where(at_high, slope, -np.inf))
        # a coordinate without room is at both bounds
        inwards[low >= high] = -np.inf
        k = int(np.argmax(inwards))
        if inwards[k] <= _NOISE:
            break
        at_low[k] = at_high[k] = False
    return np.asarray(np.minimum(np.maximum(x, low), high))


def _first_bound(x: Array, step: Array, low: Array, high: Array) -> tuple[int, float] | None:
    """Which coordinate meets its bound first on a step, and after what share of it; None when none does."""
    ahead = np.where(step > 0.0, high - x, np.where(step < 0.0, x - low, np.inf))
    with np.errstate(divide="ignore", invalid="ignore"):
        shares = np.where(step != 0.0, ahead / np.abs(step), np.inf)
    k = int(np.argmin(shares))
    return (k, max(float(shares[k]), 0.0)) if shares[k] < 1.0 else None
