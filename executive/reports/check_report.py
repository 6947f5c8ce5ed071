"""What ``executive check`` found: lines for people, and a document.

The document is that of ``docs/reference/check-report.schema.json``.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from executive.exit_codes import ExitCode
from executive.meaning import shortened
from kinematics.motion.trajectory import Trajectory
from kinematics.motion.verdict import CheckedTrajectory, Finding, FindingKind, Unsafe

SCHEMA = 1

Outcome = Literal["safe", "unsafe", "failed", "refused", "question"]

_UNITS = {
    FindingKind.POSITION_LIMIT: "rad",
    FindingKind.VELOCITY_LIMIT: "rad/s",
    FindingKind.ACCELERATION_LIMIT: "rad/s^2",
    FindingKind.JERK_LIMIT: "rad/s^3",
    FindingKind.EFFORT_LIMIT: "Nm",
    FindingKind.DISCONTINUITY: "rad/s^2",
    FindingKind.BOUNDARY_VELOCITY: "rad/s",
}
_SUBJECT_UNITS = {
    "base position": "m",
    "base orientation": "rad",
    "base quaternion": "",
    "base velocity": "m/s",
}


def unit_of(finding: Finding) -> str:
    """Unit of a finding's value and limit; empty for a number without one."""
    if finding.subject[0] in _SUBJECT_UNITS:
        return _SUBJECT_UNITS[finding.subject[0]]
    if finding.kind is FindingKind.STANCE and finding.subject[1:] == ("orientation",):
        return "rad"
    return _UNITS.get(finding.kind, "m")


@dataclass(frozen=True, slots=True)
class MotionVerdict:
    """One motion and what the checker says about it."""

    name: str
    trajectory: Trajectory
    answer: CheckedTrajectory | Unsafe

    @property
    def findings(self) -> tuple[Finding, ...]:
        """In order of time; none when it is safe."""
        return self.answer.findings if isinstance(self.answer, Unsafe) else ()

    def lines(self) -> Iterator[str]:
        """For people: a line for the motion, and one for each finding."""
        motion = self.trajectory
        head = f"{self.name}: {motion.duration_s:.2f} s, {len(motion.t_s)} samples"
        if isinstance(self.answer, CheckedTrajectory):
            yield f"{head}: safe" + (f"; {self.answer.margins}" if self.answer.margins else "")
            return
        count = len(self.findings)
        yield f"{head}: unsafe, {count} finding{'s' if count > 1 else ''}"
        for finding in self.findings:
            names, unit = " and ".join(finding.subject), unit_of(finding)
            yield (
                f"  at {finding.t_s:.3f} s  {finding.kind.value} of {names}: "
                f"{finding.value:.4g} {unit}, limit {finding.limit:.4g} {unit}".replace(" ,", ",").rstrip()
            )

    def to_json(self) -> dict[str, Any]:
        """As the report writes a motion."""
        checked = self.answer if isinstance(self.answer, CheckedTrajectory) else None
        return {
            "name": self.name,
            "duration_s": self.trajectory.duration_s,
            "samples": len(self.trajectory.t_s),
            "safe": checked is not None,
            "min_distance_m": None if checked is None else _finite(checked.min_distance_m),
            "min_com_margin_m": None if checked is None else _finite(checked.min_com_margin_m),
            "findings": [
                {
                    "kind": finding.kind.value,
                    "t_s": finding.t_s,
                    "subject": list(finding.subject),
                    "value": _finite(finding.value),
                    "limit": finding.limit,
                    "unit": unit_of(finding),
                }
                for finding in self.findings
            ],
        }


@dataclass(frozen=True, slots=True)
class CheckReport:
    """Everything that ``executive check`` tells of a sentence or a stored trajectory.

    Attributes:
        input: The file or the sentence.
        robot: Name of the robot.
        scene: Name or path of the scene; None when there was only the floor.
        outcome: "safe" when every motion is.
        exit_code: What the command ends with.
        message: The last line, as people read it.
        notes: What was assumed or looked at, in order.
        motions: What was judged, in order.
        failure: Why there is nothing to judge, or None.
    """

    input: str
    robot: str
    scene: str | None
    outcome: Outcome
    exit_code: ExitCode
    message: str
    notes: Sequence[str] = ()
    motions: Sequence[MotionVerdict] = ()
    failure: Mapping[str, Any] | None = field(default=None)

    def lines(self) -> Iterator[str]:
        """For people, the verdict last."""
        yield from self.notes
        for motion in self.motions:
            yield from motion.lines()
        yield self.message

    def to_json(self) -> dict[str, Any]:
        """The document."""
        return {
            "schema": SCHEMA,
            "input": shortened(self.input),
            "robot": self.robot,
            "scene": self.scene,
            "outcome": self.outcome,
            "exit_code": int(self.exit_code),
            "message": self.message,
            "notes": list(self.notes),
            "motions": [motion.to_json() for motion in self.motions],
            "failure": self.failure,
        }


def _finite(value: float) -> float | None:
    """JSON has no infinity: what was never measured, or is beyond all measure, is null."""
    return value if math.isfinite(value) else None
