"""Shares and times with the uncertainty that so many episodes leave."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

CONFIDENCE = 0.95
_DRAWS = 2000


def interval(count: int, of: int) -> tuple[float, float]:
    """The 95 % interval of a share, by Wilson's score."""
    from scipy.stats import binomtest  # half a second, of every process that runs episodes

    found = binomtest(count, of).proportion_ci(confidence_level=CONFIDENCE, method="wilson")
    return float(found.low), float(found.high)


def share_text(count: int, of: int) -> str:
    """A share as people read it: "97.0 % (91.5 to 99.0)"."""
    if of == 0:
        return "none"
    low, high = interval(count, of)
    return f"{count / of:.1%} ({low:.1%} to {high:.1%})"


@dataclass(frozen=True, slots=True)
class PairedShares:
    """How often two settings were good at the same episodes.

    Attributes:
        both, first, second, neither: Number of episodes that were good with both, with one alone, with none.
    """

    both: int
    first: int
    second: int
    neither: int

    @property
    def p_value(self) -> float:
        """How probable a difference like this is between equals: McNemar's exact test."""
        from scipy.stats import binomtest

        changed = self.first + self.second
        return float(binomtest(self.first, changed).pvalue) if changed else 1.0


def ratio_interval(
    first: Sequence[float], second: Sequence[float], rng: np.random.Generator
) -> tuple[float, float, float]:
    """How many times the first the second takes, and the 95 % interval of that.

    Args:
        first, second: Times of the same episodes, above 0.
        rng: Draws the episodes anew, pair by pair (bootstrap of the median of the logarithms).
    """
    logs = np.log(np.asarray(second)) - np.log(np.asarray(first))
    medians = np.median(rng.choice(logs, (_DRAWS, len(logs))), axis=1)
    tail = 50.0 * (1.0 - CONFIDENCE)
    low, high = np.exp(np.percentile(medians, (tail, 100.0 - tail)))
    return float(np.exp(np.median(logs))), float(low), float(high)
