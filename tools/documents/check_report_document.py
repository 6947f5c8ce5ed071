"""What the report of a check says: the model of docs/reference/check-report.schema.json."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field, NonNegativeFloat, PositiveFloat

from executive.exit_codes import ExitCode
from executive.reports.check_report import SCHEMA, Outcome
from kinematics.motion.verdict import FindingKind
from tools.documents.published import Published, constant

_ENDS = (ExitCode.DONE, ExitCode.FAILED, ExitCode.INVALID, ExitCode.QUESTION, ExitCode.UNSAFE)
Measure = Annotated[
    float | None,
    Field(description="null: never measured because everything is far apart, or beyond all measure."),
]


class FindingDocument(Published):
    """One thing that is wrong with a motion."""

    kind: FindingKind
    t_s: NonNegativeFloat
    subject: Annotated[list[str], Field(min_length=1)]
    value: Measure
    limit: float
    unit: Literal["rad", "rad/s", "rad/s^2", "rad/s^3", "Nm", "m", "m/s", ""]


class MotionDocument(Published):
    """One motion, and what the checker says about it."""

    name: str
    duration_s: PositiveFloat
    samples: Annotated[int, Field(ge=2)]
    safe: bool
    min_distance_m: Measure
    min_com_margin_m: Measure
    findings: list[FindingDocument]
    """In order of time; empty when it is safe."""


class CheckReportDocument(Published):
    """Written by `executive check … --report FILE.json`."""

    schema_: Annotated[int, constant(SCHEMA, key="schema")]
    input: str
    """The file, the script or the sentence; shortened when very long."""
    robot: str
    scene: str | None
    """Name of a scene, or path of a scene file; null when there was only the floor."""
    outcome: Outcome
    exit_code: Annotated[int, constant(*_ENDS)]
    message: str
    """The last line, as people read it."""
    notes: list[str]
    """What was assumed or looked at, in order."""
    motions: list[MotionDocument]
    """What was judged, in order."""
    failure: dict[str, Any] | None
    """Why there was nothing to judge, or why it is unsafe, as in report.schema.json."""
