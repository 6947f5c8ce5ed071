"""``executive jog``: take a served robot in hand, by keys, and give the task back."""

from __future__ import annotations

import sys
from contextlib import closing

import typer

from executive.cli.commands.choices import FolderOption
from executive.cli.standard_streams import tell_result
from executive.config import runtime_directory
from executive.exit_codes import ExitCode


def jog(folder: FolderOption = None) -> None:
    """Jog a served robot by keys: hand, joints, base, head, fingers; then give its task back."""
    from rich.console import Console
    from rich.live import Live
    from rich.text import Text

    from executive.doors.jog_door import JogDoor, told_at_the_end
    from executive.doors.jog_door import jog as jogged
    from executive.errors import UserError
    from executive.live.caller.caller import ask_at
    from executive.manual.keys import keys_for
    from executive.screens.jog_screen import JogScreen, jog_lines
    from executive.screens.keyboard import Keyboard
    from robots.clock import WallClock
    from robots.live.wire.messages import GetStatus, write_control_message
    from robots.live.wire.runtime_folder import RuntimeFolder
    from robots.models.description import load_description

    if not sys.stdin.isatty():
        raise UserError("jogging needs a terminal: keys are read one by one")
    where = folder or runtime_directory()
    served = ask_at(RuntimeFolder(where).control_socket, write_control_message(GetStatus()))
    keys = keys_for(load_description(str(served["robot"])))
    console = Console(stderr=True)
    with closing(JogDoor(where)) as door:
        with Keyboard(sys.stdin) as keyboard, Live(console=console, auto_refresh=False) as live:

            def show(screen: JogScreen) -> None:
                lines = "\n".join(jog_lines(screen, console.width))
                live.update(Text(lines, no_wrap=True, overflow="crop"), refresh=True)

            jogged(door, keyboard, keys, show, WallClock())
        line, code = told_at_the_end(door, WallClock())
    tell_result(line)
    raise typer.Exit(ExitCode(code))
