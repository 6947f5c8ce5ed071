"""``executive pause``: a served robot holds in the middle of what it does."""

from __future__ import annotations

from typing import Annotated

import typer

from executive.cli.commands.choices import FolderOption
from executive.config import runtime_directory
from executive.exit_codes import ExitCode


def pause(
    reason: Annotated[str, typer.Option(help="Why, for the log.")] = "paused by a person",
    folder: FolderOption = None,
) -> None:
    """Hold the task that is under way where it is, until `resume`."""
    from executive.live.caller.caller import ask_at
    from executive.live.desk_messages import PauseTask, write_desk_message
    from robots.live.wire.runtime_folder import RuntimeFolder

    where = RuntimeFolder(folder or runtime_directory())
    if not ask_at(where.executive_socket, write_desk_message(PauseTask(reason))).get("under_way"):
        typer.echo("nothing is under way")
        raise typer.Exit(ExitCode.INVALID)
    typer.echo("paused; `executive resume` goes on, `executive cancel` gives it up")
