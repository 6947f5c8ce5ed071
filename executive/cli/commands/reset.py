"""``executive reset``: a person's command to leave the emergency stop."""

from __future__ import annotations

import getpass

import typer

from executive.cli.commands.choices import FolderOption
from executive.config import runtime_directory
from executive.exit_codes import ExitCode


def reset(folder: FolderOption = None) -> None:
    """Leave the emergency stop; nothing moves because of it."""
    from executive.live.caller.caller import ask_at
    from robots.live.wire.messages import Reset, write_control_message
    from robots.live.wire.runtime_folder import RuntimeFolder

    where = RuntimeFolder(folder or runtime_directory())
    answer = ask_at(where.control_socket, write_control_message(Reset(_person())))
    if answer["type"] != "done":
        typer.echo(f"refused: {answer['reason']}")
        raise typer.Exit(ExitCode.INVALID)
    typer.echo("the emergency stop is left; the robot takes tasks again")


def _person() -> str:
    try:
        return getpass.getuser()
    except (KeyError, OSError):
        return "somebody"
