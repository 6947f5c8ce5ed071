"""``executive stop``: the emergency stop of a served robot, past everything but its control process."""

from __future__ import annotations

from typing import Annotated

import typer

from executive.cli.commands.choices import FolderOption, whole_number_from
from executive.config import runtime_directory


def stop(
    category: Annotated[
        int,
        typer.Option(
            parser=whole_number_from(0, 2),
            metavar="0|1|2",
            help="1 brakes along the path, 2 holds at once, 0 takes the power away.",
        ),
    ] = 1,
    reason: Annotated[str, typer.Option(help="Why, for the log.")] = "a person stopped it",
    folder: FolderOption = None,
) -> None:
    """Stop the robot, and keep it stopped until ``executive reset``."""
    from executive.live.caller.caller import ask_at
    from robots.live.wire.messages import Stop, write_control_message
    from robots.live.wire.runtime_folder import RuntimeFolder

    where = RuntimeFolder(folder or runtime_directory())
    ask_at(where.control_socket, write_control_message(Stop(category, reason)))
    typer.echo("stopped; the emergency stop stays engaged until `executive reset`")
