"""How a task ended."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from executive.exit_codes import ExitCode
from executive.meaning import Command
from executive.understanding.provenance import Provenance
from trees.beliefs.scene.scene_update import kind_of
from trees.failures import Failure, FailureKind, Number
from trees.tasks import ObjectDescription

Outcome = Literal["done", "failed", "refused", "question", "cancelled"]


@dataclass(frozen=True, slots=True)
class TaskTimes:
    """Seconds that a task took: wall time spent planning, simulated time, wall time."""

    planning_wall_s: float = 0.0
    simulated_s: float = 0.0
    wall_s: float = 0.0


@dataclass(frozen=True, slots=True)
class TaskResult:
    """How a task ended.

    Attributes:
        text: The words that it came from.
        action: What was asked for: "pick", "go_home", ...; "none" when nothing was understood.
        outcome: "done" is claimed from the robot's own sensors.
        attempts: How many times the main part was tried.
        failure: Why it was not done, or None.
        evidence: What was measured at the end.
        times: How long it took.
        subject: What was acted on, in words: "red cup"; empty when there is nothing to name.
        acted_on: Its name in the planning scene, or None.
        others: Names of further objects that the command means and that are still to be acted on.
        provenance: Which step of a model's output it comes from, or None.
    """

    text: str
    action: str
    outcome: Outcome
    attempts: int = 0
    failure: Failure | None = None
    evidence: Mapping[str, Number] = field(default_factory=dict)
    times: TaskTimes = field(default_factory=TaskTimes)
    subject: str = ""
    acted_on: str | None = None
    others: tuple[str, ...] = ()
    provenance: Provenance | None = None

    @property
    def exit_code(self) -> ExitCode:
        """The exit code that this result calls for."""
        match self.outcome:
            case "done":
                return ExitCode.DONE
            case "question":
                return ExitCode.QUESTION
            case "cancelled":
                return ExitCode.CANCELLED
            case "refused" if self.failure is None:
                return ExitCode.INVALID
            case "refused" | "failed":
                return failure_exit_code(self.failure)

    def to_json(self) -> dict[str, Any]:
        """As the report writes a task."""
        provenance = {} if self.provenance is None else {"provenance": self.provenance.to_json()}
        return {
            "text": self.text,
            "action": self.action,
            "outcome": self.outcome,
            "attempts": self.attempts,
            "failure": None if self.failure is None else self.failure.to_json(),
            "time_s": {
                "planning_wall": round(self.times.planning_wall_s, 4),
                "simulated": round(self.times.simulated_s, 4),
                "wall": round(self.times.wall_s, 4),
            },
            "evidence": dict(self.evidence),
            **({"by": self.evidence["by"]} if "by" in self.evidence else {}),
            **provenance,
        }


def failure_exit_code(failure: Failure | None) -> ExitCode:
    """The exit code of a failure: cancelled, refused by a safety check at its root, or just failed."""
    kinds = [link.kind for link in chain(failure)]
    if FailureKind.CANCELED in kinds:
        return ExitCode.CANCELLED
    if kinds and kinds[-1] in (FailureKind.UNSAFE, FailureKind.REFUSED):
        return ExitCode.UNSAFE
    return ExitCode.FAILED


def chain(failure: Failure | None) -> list[Failure]:
    """The failure and its causes, the root last."""
    links: list[Failure] = []
    while failure is not None:
        links.append(failure)
        failure = failure.cause
    return links


def subject_of(command: Command, acted_on: str | None) -> str:
    """What a command is about, in words: where no noun was said, the name of what it came to be."""
    wanted = getattr(command, "object", None)
    has_noun = not isinstance(wanted, ObjectDescription) or bool(wanted.kind or wanted.name)
    if acted_on is not None and (wanted is None or not has_noun):
        return kind_of(acted_on)
    return "" if wanted is None else str(wanted)
