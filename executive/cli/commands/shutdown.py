"""``executive shutdown``: end a served robot's control, once it is at rest."""

from __future__ import annotations

import typer

from executive.cli.commands.choices import FolderOption
from executive.config import runtime_directory


def shutdown(folder: FolderOption = None) -> None:
    """Have the robot brake and hold, then end its control."""
    from executive.live.caller.caller import ask_at
    from robots.live.wire.messages import Shutdown, write_control_message
    from robots.live.wire.runtime_folder import RuntimeFolder

    where = RuntimeFolder(folder or runtime_directory())
    ask_at(where.control_socket, write_control_message(Shutdown()))
    typer.echo("the robot brakes and holds, then its control ends")
