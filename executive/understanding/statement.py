"""One thing said, alone or as a step of a script, with what is to become of it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

from executive.meaning import Parsed
from executive.understanding.provenance import Provenance
from executive.understanding.understanding import SkippedStep, Understood

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
        provenance: Where each command comes from, when a model asked for it.
        skipped: What is left out of a model's output.
        if_confirmed: What holds when a question about low confidence is answered by yes.
    """

    parsed: Parsed
    on_failure: OnFailure = "stop"
    expect: Expectation = "done"
    timeout_s: float | None = None
    provenance: tuple[Provenance, ...] = ()
    skipped: tuple[SkippedStep, ...] = ()
    if_confirmed: Understood | None = None

    @classmethod
    def of(cls, understood: Understood) -> Statement:
        """A statement on its own, to be done."""
        return cls(understood.parsed).meaning(understood)

    def meaning(self, understood: Understood) -> Statement:
        """The same statement, understood as something else."""
        return replace(
            self,
            parsed=understood.parsed,
            provenance=understood.provenance,
            skipped=understood.skipped,
            if_confirmed=understood.if_confirmed,
        )
