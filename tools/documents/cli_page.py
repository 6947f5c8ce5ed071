"""The page of the command line: what every command says of itself with ``--help``."""

from __future__ import annotations

import contextlib
import io

from executive.cli.app import app

_HEAD = """\
# The command line

What every command prints with `--help`. The [exit codes](../start/exit-codes.md) are the same for all of
them. Commands of a served robot (`send`, `answer`, `status`, `pause`, `resume`, `cancel`, `stop`, `reset`,
`shutdown`) find it by `--folder`; left out, it is the one of this user.
"""
_WIDTH = 100


def cli_page() -> str:
    """The page, in the order in which the commands are declared."""
    parts = [_HEAD, _said([])]
    for command in app.registered_commands:
        parts += [f"## {command.name}\n", _said([str(command.name)])]
    return "\n".join(parts)


def _said(command: list[str]) -> str:
    with contextlib.redirect_stdout(io.StringIO()) as shown:
        app([*command, "--help"], prog_name="executive", standalone_mode=False, terminal_width=_WIDTH)
    lines = [line.rstrip() for line in shown.getvalue().strip().splitlines()]
    return "\n".join(["```", *lines, "```", ""])
