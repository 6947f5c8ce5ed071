"""``executive reset``: a person's command to leave the emergency stop."""

from __future__ import annotations

import getpass
from typing import TYPE_CHECKING

import typer

from executive.cli.commands.choices import FolderOption
from executive.config import runtime_directory
from executive.exit_codes import ExitCode

if TYPE_CHECKING:
    from robots.live.wire.runtime_folder import RuntimeFolder

LEFT = "the emergency stop is left; the robot takes tasks again"


def reset(folder: FolderOption = None) -> None:
    """Leave the emergency stop; nothing moves because of it."""
    from robots.live.wire.runtime_folder import RuntimeFolder

    told = leave_stop(RuntimeFolder(folder or runtime_directory()))
    typer.echo(told)
    if told != LEFT:
        raise typer.Exit(ExitCode.INVALID)


def leave_stop(where: RuntimeFolder) -> str:
    """Leave the emergency stop for the person at this terminal, and tell whether that was done.

    Raises:
        LiveError: No robot is served there, or it does not answer.
    """
    from executive.live.caller.caller import ask_at
    from robots.live.wire.messages import Reset, write_control_message

    answer = ask_at(where.control_socket, write_control_message(Reset(_person())))
    return LEFT if answer["type"] == "done" else f"refused: {answer['reason']}"


def _person() -> str:
    try:
        return getpass.getuser()
    except (KeyError, OSError):
        return "somebody"
