"""From how surely things were seen to how often an answer about them is right."""

from __future__ import annotations

import math

_NEAREST = 1e-3
"""Raw confidences are kept this far from 0 and 1: nothing is that certain."""


def log_odds(chance: float) -> float:
    """Log of p / (1 - p), of a chance kept off 0 and 1."""
    kept = min(max(chance, _NEAREST), 1.0 - _NEAREST)
    return math.log(kept / (1.0 - kept))


def calibrated(raw: float, slope: float, offset: float) -> float:
    """Platt's map (1999): a line in the log-odds.

    Args:
        raw: Product of the confidences with which each thing was seen.
        slope, offset: Of the line; 1 and 0 leave the chance as it is.
    """
    return 1.0 / (1.0 + math.exp(-(slope * log_odds(raw) + offset)))
