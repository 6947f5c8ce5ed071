"""``executive resume``: a served robot goes on with what was paused."""

from __future__ import annotations

import typer

from executive.cli.commands.choices import FolderOption
from executive.config import runtime_directory
from executive.exit_codes import ExitCode


def resume(folder: FolderOption = None) -> None:
    """Go on with a paused task."""
    from executive.live.caller.caller import ask_at
    from executive.live.desk_messages import ResumeTask, write_desk_message
    from robots.live.wire.runtime_folder import RuntimeFolder

    where = RuntimeFolder(folder or runtime_directory())
    if not ask_at(where.executive_socket, write_desk_message(ResumeTask())).get("paused"):
        typer.echo("nothing is paused")
        raise typer.Exit(ExitCode.INVALID)
    typer.echo("going on")
