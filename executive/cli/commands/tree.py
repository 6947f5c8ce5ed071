"""``executive tree``: print the behavior tree that would run; moves nothing."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from executive.cli.commands.choices import ConfigOption
from executive.config import use_config
from executive.errors import UserError
from executive.exit_codes import ExitCode


class TreeFormat(StrEnum):
    """How to print a tree."""

    TEXT = "text"
    DOT = "dot"
    SVG = "svg"
    XML = "xml"
    JSON = "json"


def tree(
    text: Annotated[
        str, typer.Argument(metavar="SENTENCE|FILE.xml", help="What would be done, or a tree of Groot2.")
    ],
    config: ConfigOption = None,
    form: Annotated[TreeFormat, typer.Option("--format", help="How to print it.")] = TreeFormat.TEXT,
) -> None:
    """Print the tree that would run, or the one that a file of BehaviorTree.CPP 4 describes."""
    if text.endswith(".xml"):
        _of_file(Path(text), form)
        return
    from executive.scripts.task_script import is_script
    from executive.understanding.command_parser import parse

    if is_script(text):
        raise UserError(f"{text}: a tree is printed of one sentence, or of a FILE.xml; a script has many")
    from executive.meaning import StopCommand

    use_config(config)
    parsed = parse(text)
    if parsed.refusal is not None:
        typer.echo(f"refused: {parsed.refusal}", err=True)
        raise typer.Exit(ExitCode.INVALID)
    if parsed.question is not None:
        typer.echo(f"question: {parsed.question.text}", err=True)
        raise typer.Exit(ExitCode.QUESTION)
    from executive.checks.tree_preview import preview, preview_document
    from executive.screens.tree_formats import FORMATS

    for command in parsed.commands:
        if isinstance(command, StopCommand):
            typer.echo("stop: cancels what is under way and holds; no tree", err=True)
        elif form is TreeFormat.XML:
            typer.echo(preview_document(command))
        else:
            typer.echo(FORMATS[form.value](preview(command)))


def _of_file(path: Path, form: TreeFormat) -> None:
    from executive.checks.tree_preview import preview_of_document, rewritten_document
    from executive.screens.tree_formats import FORMATS

    try:
        text = path.read_text("utf-8")
    except (OSError, UnicodeDecodeError) as broken:
        raise UserError(f"{path} cannot be read: {broken}") from broken
    if form is TreeFormat.XML:
        typer.echo(rewritten_document(text, str(path)))
    else:
        typer.echo(FORMATS[form.value](preview_of_document(text, str(path))))
