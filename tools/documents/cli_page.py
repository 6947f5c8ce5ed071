"""The page of the command line: what every command says of itself with ``--help``."""

from __future__ import annotations

import typer
from typer.testing import CliRunner

from executive.cli.app import app

_HEAD = """\
# The command line

What every command prints with `--help`. The [exit codes](../start/exit-codes.md) are the same for all of
them. Commands of a served robot (`send`, `answer`, `status`, `pause`, `resume`, `cancel`, `stop`, `reset`,
`shutdown`) find it by `--folder`; left out, it is the one of this user.
"""
_WIDTH = "100"


def cli_page() -> str:
    """The page, in the order in which the commands are declared."""
    parts = [_HEAD, _said([])]
    for name in getattr(typer.main.get_command(app), "commands"):  # noqa: B009
        parts += [f"## {name}\n", _said([name])]
    return "\n".join(parts)


def _said(command: list[str]) -> str:
    shown = CliRunner().invoke(app, [*command, "--help"], prog_name="executive", env={"COLUMNS": _WIDTH})
    lines = [line.rstrip() for line in shown.stdout.strip().splitlines()]
    return "\n".join(["```", *lines, "```", ""])
