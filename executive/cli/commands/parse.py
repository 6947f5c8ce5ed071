"""``executive parse``: what a sentence, or a model's output, means, as JSON."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated

import typer

from executive.config import use_config
from executive.errors import UserError
from executive.exit_codes import ExitCode

_EXIT_CODES = {"tasks": ExitCode.DONE, "refused": ExitCode.INVALID, "question": ExitCode.QUESTION}


def parse(
    text: Annotated[str, typer.Argument(metavar="SENTENCE|-|FILE|SCRIPT.toml", help="What to understand.")],
    config: Annotated[Path | None, typer.Option(help="A TOML file with words of your own.")] = None,
) -> None:
    """Say what a sentence or a model's output means; for - or a file, one line of JSON for each line.

    Of a task script, for each statement.
    """
    from executive.scripts.task_script import load_script
    from executive.understanding.understanding import understand

    use_config(config)
    if text.endswith(".toml"):
        for statement in load_script(Path(text)).statements:
            typer.echo(json.dumps(statement.parsed.to_json()))
        return
    lines = _lines(text)
    if lines is None:
        parsed = understand(text).parsed
        typer.echo(json.dumps(parsed.to_json()))
        raise typer.Exit(_EXIT_CODES[parsed.outcome])
    for line in lines:
        typer.echo(json.dumps(understand(line).parsed.to_json()))


def _lines(text: str) -> Iterator[str] | None:
    if text == "-":
        return (line.decode("utf-8", "replace").rstrip("\r\n") for line in sys.stdin.buffer)
    try:
        if not Path(text).is_file():
            return None
        content = Path(text).read_bytes()
    except ValueError:
        return None
    except OSError as failed:
        if len(text) > 255:
            return None
        raise UserError(f"cannot read {text}: {failed.strerror}") from failed
    return (line.decode("utf-8", "replace").rstrip("\r") for line in content.removesuffix(b"\n").split(b"\n"))
