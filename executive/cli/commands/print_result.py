"""The last line of what a robot has done; that it cannot be written does not change what was done."""

from __future__ import annotations

import sys

import typer

from executive.errors import OutputLostError


def tell_result(line: str) -> None:
    """Write the result on standard output; where that is lost, say so and keep the exit code of the task."""
    try:
        typer.echo(sayable(line))
    except OutputLostError as lost:
        if not lost.unread:
            typer.echo(f"executive: {lost}; the result: {line}", err=True)


def sayable(line: str) -> str:
    """What standard output can show of a line."""
    encoding = sys.stdout.encoding or "utf-8"
    return line.encode(encoding, "backslashreplace").decode(encoding)
