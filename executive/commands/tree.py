"""``executive tree``: print the behavior tree that would run; moves nothing."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated

import typer

from executive.commands.config_option import ConfigOption
from executive.config import use_config
from executive.exit_codes import ExitCode


class TreeFormat(StrEnum):
    """How to print a tree."""

    TEXT = "text"
    DOT = "dot"
    XML = "xml"
    JSON = "json"


def tree(
    text: Annotated[str, typer.Argument(metavar="SENTENCE", help="What would be done.")],
    config: ConfigOption = None,
    form: Annotated[TreeFormat, typer.Option("--format", help="How to print it.")] = TreeFormat.TEXT,
) -> None:
    """Print the tree that would run."""
    from executive.command_parser import parse
    from executive.meaning import StopCommand

    use_config(config)
    parsed = parse(text)
    if parsed.refusal is not None:
        typer.echo(f"refused: {parsed.refusal}", err=True)
        raise typer.Exit(ExitCode.INVALID)
    if parsed.question is not None:
        typer.echo(f"question: {parsed.question.text}", err=True)
        raise typer.Exit(ExitCode.QUESTION)
    from executive.outputs.tree_formats import FORMATS
    from executive.tree_preview import preview

    for command in parsed.commands:
        if isinstance(command, StopCommand):
            typer.echo("stop: cancels what is under way and holds; no tree", err=True)
        else:
            typer.echo(FORMATS[form.value](preview(command)))
