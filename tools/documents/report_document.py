"""What the report of a run says: the model of docs/reference/report.schema.json."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, NonNegativeFloat, NonNegativeInt

from executive.exit_codes import ExitCode
from executive.reports.report import SCHEMA
from executive.session.task_result import Outcome
from tools.documents.published import Published, absent, constant
from trees.failures import FailureKind, Number, Reason

_ENDS = tuple(code for code in ExitCode if code is not ExitCode.UNREAD)
"""Whoever was to read a report has gone where a command ends with ``UNREAD``: there is none."""

_REASONS = tuple(reason.name for reason in Reason if reason is not Reason.KIND_ONLY)


class ProvenanceDocument(Published):
    """Which step of a model's output it comes from; absent for what a person said."""

    step: NonNegativeInt
    confidence: Annotated[float, Field(ge=0.0, le=1.0)]
    form: Literal["sentence", "action"]


class OpenChoiceDocument(Published):
    """What a person has to choose from, where several things fit."""

    words: list[str]
    names: list[str]
    """Names in the planning scene, in the order of the words."""
    slot: str
    """The task's slot that the choice fills in."""
    unseen: NonNegativeInt
    """How many of them the task has not seen."""
    one_will_do: bool
    """Whether nobody has to be asked where there is one choice alone."""


class FindingDocument(Published):
    """What the checker found first, where it refused a motion."""

    kind: str
    t_s: Number
    subject: list[str]
    value: Number
    limit: Number
    place_m: list[float] | None = None
    """Where a pair first touches, m, in the odometry frame; absent where nobody measured it."""


class FailureDocument(Published):
    """Why a task was not done."""

    kind: FailureKind
    where: str
    """Place in the tree, names joined by "/"."""
    message: str
    numbers: dict[str, Number]
    """For people; programs decide by kind, reason and what follows."""
    reason: Annotated[str, Field(json_schema_extra={"enum": list(_REASONS)})] = absent()
    """Why, where the kind does not say it all; trees.failures.Reason has the meanings."""
    open_choice: OpenChoiceDocument = absent()
    finding: FindingDocument = absent()
    cause: FailureDocument | None
    """The failure that led to it."""


class TimesDocument(Published):
    """Seconds that a task took."""

    planning_wall: NonNegativeFloat
    simulated: NonNegativeFloat
    wall: NonNegativeFloat


class TaskDocument(Published):
    """How one task ended."""

    text: str
    action: str
    """As `parse` names it; "none" when nothing was understood."""
    outcome: Outcome
    attempts: NonNegativeInt
    failure: FailureDocument | None
    time_s: TimesDocument
    evidence: dict[str, Number]
    by: Literal["person"] = absent()
    """That a person had the task in hand for a while."""
    provenance: ProvenanceDocument = absent()


class SafetyDocument(Published):
    """What checker, gate and stop profile did."""

    checked_trajectories: NonNegativeInt
    """Trajectories that passed the checker."""
    refused_setpoints: NonNegativeInt
    stops: list[str]
    """Why a stop profile took over."""


class LeftOutDocument(Published):
    """A step of a model's output that was not carried out."""

    text: str
    reason: str
    provenance: ProvenanceDocument


class ReportDocument(Published):
    """Written by `executive run --report FILE.json`, and as report.json beside every recorded run."""

    schema_: Annotated[int, constant(SCHEMA, key="schema")]
    input: str
    """The sentence or the script's name; shortened when very long."""
    seed: NonNegativeInt
    robot: str
    scene: str
    """Name of a scene, or path of a scene file."""
    outcome: Outcome
    exit_code: Annotated[int, constant(*_ENDS)]
    message: str
    """The last line, as people read it."""
    tasks: list[TaskDocument]
    safety: SafetyDocument
    left_out: list[LeftOutDocument] = absent()
    """Steps of a model's output that were not carried out; absent when there are none."""
    pictures: list[str] = absent()
    """Files in the run's folder: what the camera showed of things that a person was asked about."""
    events_sha256: Annotated[str, Field(pattern="^[0-9a-f]{64}$")]
    """Over the canonical events; equal for equal runs on one machine."""
