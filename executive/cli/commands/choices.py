"""Options that several commands share."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from executive.cli.commands.numbers import number_from

ConfigOption = Annotated[
    Path | None,
    typer.Option("--config", metavar="FILE.toml", help="A TOML file with words of your own."),
]

FolderOption = Annotated[
    Path | None, typer.Option("--folder", metavar="DIR", help="Where the sockets are; one for each robot.")
]


def not_empty(name: str | None) -> str | None:
    """A name as it was given; an empty one is a mistake, not one that was left out."""
    if name is not None and not name.strip():
        raise typer.BadParameter("the name is empty; leave the option out for the usual one")
    return name


class OnQuestionChoice(StrEnum):
    """What becomes of a question."""

    ASK = "ask"
    FAIL = "fail"
    FIRST = "first"


class PolicyChoice(StrEnum):
    """What happens below the confidence."""

    ASK = "ask"
    PARTIAL = "partial"


class PaceChoice(StrEnum):
    """How fast simulated time passes."""

    FAST = "fast"
    REAL = "real"


OnQuestionOption = Annotated[
    OnQuestionChoice, typer.Option("--on-question", help="What becomes of a question.")
]
ConfidenceOption = Annotated[
    float,
    typer.Option(
        parser=number_from(0.0, 1.0), metavar="0..1", help="Below it a model's steps are not done unasked."
    ),
]
PolicyOption = Annotated[
    PolicyChoice, typer.Option(help="Below the confidence: ask, or do the other steps only.")
]
