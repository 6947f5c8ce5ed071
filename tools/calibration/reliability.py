"""How often answers of about the same stated confidence are right."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from tools.calibration.answers import Answer

EDGES = (0.0, 0.3, 0.5, 0.6, 0.7, 0.8, 0.85, 0.9, 0.95, 0.98, 1.0)
"""Finer where most answers are."""
_Z = 1.96


@dataclass(frozen=True, slots=True)
class Bin:
    """Answers whose stated confidences are near each other.

    Attributes:
        count: How many.
        stated: Mean of what they stated.
        right: Share of them that is right.
        low, high: Wilson's 95 % interval of that share.
    """

    count: int
    stated: float
    right: float
    low: float
    high: float


def reliability(answers: Sequence[Answer]) -> list[Bin]:
    """The bins that have answers, the least sure first."""
    bins = []
    for low, high in pairwise(EDGES):
        some = [a for a in answers if low < a.stated <= high or (a.stated == low == 0.0)]
        if some:
            share = sum(answer.right for answer in some) / len(some)
            stated = sum(answer.stated for answer in some) / len(some)
            bins.append(Bin(len(some), stated, share, *_wilson(share, len(some))))
    return bins


def expected_error(answers: Sequence[Answer]) -> float:
    """Mean distance of stated from true over the bins, each by its number of answers."""
    if not answers:
        return 0.0
    return sum(item.count * abs(item.stated - item.right) for item in reliability(answers)) / len(answers)


def _wilson(share: float, count: int) -> tuple[float, float]:
    """Wilson (1927): the interval of a share of few."""
    centre = (share + _Z * _Z / (2 * count)) / (1 + _Z * _Z / count)
    half = _Z / (1 + _Z * _Z / count) * math.sqrt(share * (1 - share) / count + (_Z / (2 * count)) ** 2)
    return max(0.0, centre - half), min(1.0, centre + half)
