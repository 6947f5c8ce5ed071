"""Where a command came from."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal


@dataclass(frozen=True, slots=True)
class Provenance:
    """Where a task comes from when a model asked for it.

    Attributes:
        step: Index of the step in the model's output.
        confidence: That the model gave for it.
        form: Whether the step was a sentence or a structured action.
    """

    step: int
    confidence: float
    form: Literal["sentence", "action"]

    def to_json(self) -> dict[str, Any]:
        """As the report writes it."""
        return {"step": self.step, "confidence": self.confidence, "form": self.form}
