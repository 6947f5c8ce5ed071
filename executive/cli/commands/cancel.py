"""``executive cancel``: halt what a served robot does; it holds, and takes the next task."""

from __future__ import annotations

from typing import Annotated

import typer

from executive.cli.commands.choices import FolderOption
from executive.config import runtime_directory


def cancel(
    reason: Annotated[str, typer.Option(help="Why, for the log.")] = "cancelled by a person",
    folder: FolderOption = None,
) -> None:
    """Cancel the task that is under way."""
    from executive.live.caller.caller import ask_at
    from executive.live.desk_messages import Cancel, write_desk_message
    from robots.live.wire.runtime_folder import RuntimeFolder

    where = RuntimeFolder(folder or runtime_directory())
    answer = ask_at(where.executive_socket, write_desk_message(Cancel(reason)))
    typer.echo("cancelled" if answer.get("under_way") else "nothing is under way")
