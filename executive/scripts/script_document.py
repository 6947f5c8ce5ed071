"""What a task script may say, key by key."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field, FiniteFloat, NonNegativeInt

from executive.understanding.statement import Expectation, OnFailure
from robots.strict_table import StrictTable


class TaskTable(StrictTable):
    """``[[task]]``: a sentence, and what to expect of it."""

    say: str
    on_failure: OnFailure = "stop"
    expect: Expectation = "done"
    timeout_s: Annotated[FiniteFloat, Field(gt=0.0)] | None = None


class ScriptDocument(StrictTable):
    """A whole script; what is absent is for the command line to say."""

    scene: str | None = None
    robot: str | None = None
    seed: NonNegativeInt | None = None
    task: Annotated[list[TaskTable], Field(min_length=1)]
