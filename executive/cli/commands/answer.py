"""``executive answer``: answer the question that a served robot has put."""

from __future__ import annotations

from typing import Annotated

import typer

from executive.cli.commands.choices import FolderOption
from executive.config import runtime_directory
from executive.exit_codes import ExitCode


def answer(
    text: Annotated[str, typer.Argument(help="The answer: a number, or words.")],
    folder: FolderOption = None,
) -> None:
    """Answer the question that is open."""
    from executive.live.caller.caller import ask_at
    from executive.live.desk_messages import Answer, write_desk_message
    from robots.live.wire.runtime_folder import RuntimeFolder

    where = RuntimeFolder(folder or runtime_directory())
    if not ask_at(where.executive_socket, write_desk_message(Answer(text))).get("asked"):
        typer.echo("no question is open")
        raise typer.Exit(ExitCode.INVALID)
    typer.echo("answered")
