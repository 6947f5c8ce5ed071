"""The report of a run: one JSON document, its schema in ``docs/reference/report.schema.json``."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from executive.meaning import shortened
from executive.session.events import Event, plain
from executive.session.task_result import TaskResult
from robots.control.events import SetpointRefused, StopStarted

if TYPE_CHECKING:
    from executive.understanding.understanding import SkippedStep


SCHEMA = 1


@dataclass(frozen=True, slots=True)
class SafetyCounts:
    """What checker, gate and stop profile did in a run; ``stops`` are their reasons."""

    checked_trajectories: int = 0
    refused_setpoints: int = 0
    stops: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Report:
    """Everything that a run's report says; ``message`` is the line that people read."""

    input: str
    seed: int
    robot: str
    scene: str
    outcome: str
    exit_code: int
    message: str
    events_sha256: str
    tasks: Sequence[TaskResult] = ()
    safety: SafetyCounts = field(default_factory=SafetyCounts)
    left_out: Sequence[SkippedStep] = ()
    pictures: Sequence[str] = ()

    def to_json(self) -> dict[str, Any]:
        """The document."""
        document: dict[str, Any] = plain(
            {
                "schema": SCHEMA,
                "input": shortened(self.input),
                "seed": self.seed,
                "robot": self.robot,
                "scene": self.scene,
                "outcome": self.outcome,
                "exit_code": int(self.exit_code),
                "message": self.message,
                "tasks": [task.to_json() for task in self.tasks],
                "safety": {
                    "checked_trajectories": self.safety.checked_trajectories,
                    "refused_setpoints": self.safety.refused_setpoints,
                    "stops": list(self.safety.stops),
                },
                **self._left_out(),
                **({"pictures": list(self.pictures)} if self.pictures else {}),
                "events_sha256": self.events_sha256,
            }
        )
        return document

    def _left_out(self) -> dict[str, Any]:
        """Steps of a model's output that were left out; the key is absent when there are none."""
        steps = [
            {"text": step.text, "reason": step.reason, "provenance": step.provenance.to_json()}
            for step in self.left_out
        ]
        return {"left_out": steps} if steps else {}


@dataclass(slots=True)
class SafetyTally:
    """Counts what was refused and stopped, event by event, for a report.

    Attributes:
        refused: Setpoints that the gate or the online checker refused.
        stops: Why a stop profile took over, each time.
    """

    refused: int = 0
    stops: tuple[str, ...] = ()

    def add(self, event: Event) -> None:
        """Take one more event in."""
        if isinstance(event, SetpointRefused):
            self.refused += 1
        elif isinstance(event, StopStarted):
            self.stops = (*self.stops, event.reason)

    def counts(self, checked: int) -> SafetyCounts:
        """For the report, beside so many trajectories that the checker let pass."""
        return SafetyCounts(checked, self.refused, self.stops)
