"""One thing said, alone or as a step of a script, with what is to become of it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from executive.meaning import Parsed

OnFailure = Literal["stop", "continue", "retry"]
Expectation = Literal["done", "failed", "refused", "question"]


@dataclass(frozen=True, slots=True)
class Statement:
    """One thing said.

    Attributes:
        parsed: What it was understood as.
        on_failure: What to do when the result is not the expected one.
        expect: The outcome that counts as right.
        timeout_s: Simulated time that each of its tasks may take, or None for the usual.
    """

    parsed: Parsed
    on_failure: OnFailure = "stop"
    expect: Expectation = "done"
    timeout_s: float | None = None
