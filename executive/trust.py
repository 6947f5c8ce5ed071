"""How much is done unasked: a model's confidence, and what becomes of questions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

THRESHOLD = 0.8
"""Confidence from which a step is carried out without asking."""

ConfidencePolicy = Literal["ask", "partial"]
OnQuestion = Literal["ask", "fail", "first"]
"""What becomes of a question: it is put, it ends the task, or the first choice is taken."""


@dataclass(frozen=True, slots=True)
class Trust:
    """How far a model's output is trusted.

    Attributes:
        threshold: Confidence from which a step is carried out without asking.
        policy: What happens below it.
    """

    threshold: float = THRESHOLD
    policy: ConfidencePolicy = "ask"


USUAL_TRUST = Trust()
"""What holds when nobody says otherwise."""
