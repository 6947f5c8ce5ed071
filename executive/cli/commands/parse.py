"""``executive parse``: what a sentence, or a model's output, means, as JSON."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from executive.cli.commands.choices import ModelOption, YesOption, scene_given
from executive.config import use_config
from executive.errors import UserError
from executive.exit_codes import ExitCode

if TYPE_CHECKING:
    from executive.meaning import Parsed

_EXIT_CODES = {"tasks": ExitCode.DONE, "refused": ExitCode.INVALID, "question": ExitCode.QUESTION}


def parse(
    text: Annotated[str, typer.Argument(metavar="SENTENCE|-|FILE|SCRIPT.toml", help="What to understand.")],
    config: Annotated[Path | None, typer.Option(help="A TOML file with words of your own.")] = None,
    scene: Annotated[
        str | None,
        typer.Option(
            metavar="NAME|FILE.toml|FILE.xml", help="Where it is said: what things there are called."
        ),
    ] = None,
    model: ModelOption = None,
    yes: YesOption = False,
) -> None:
    """Say what a sentence or a model's output means; for - or a file, one line of JSON for each line.

    Of a task script, for each statement.
    """
    from executive.understanding.spoken_in import spoken_in

    use_config(config)
    with spoken_in(scene_given(scene)):
        _tell(text, model, yes)


def _tell(text: str, model: str | None, yes: bool) -> None:
    """Write what is understood."""
    from executive.scripts.task_script import load_script
    from executive.understanding.understanding import understand

    if text.endswith(".toml"):
        for statement in load_script(Path(text)).statements:
            typer.echo(json.dumps(statement.parsed.to_json()))
        return
    lines = _lines(text)
    if lines is None:
        parsed = understand(text).parsed
        if model is not None:
            parsed = _proposed(model, parsed, reads_back=not yes)
        typer.echo(json.dumps(parsed.to_json()))
        raise typer.Exit(_EXIT_CODES[parsed.outcome])
    for line in lines:
        typer.echo(json.dumps(understand(line).parsed.to_json()))


def _proposed(name: str, parsed: Parsed, reads_back: bool) -> Parsed:
    """What a sentence means with a model in front: what it proposes, or the question that a run would put."""
    from executive.doors.model.front_model import front_model
    from executive.front.front_talk import as_parsed
    from executive.front.proposal import Context
    from executive.trust import USUAL_TRUST
    from executive.understanding.understanding import Understood
    from robots.clock import WallClock

    front, asker = front_model(name, USUAL_TRUST, reads_back)
    wall = WallClock()

    def waiting() -> bool:
        wall.sleep(0.02)
        return False

    with asker:
        if not front.takes(parsed.text, Understood(parsed)):
            return parsed
        return as_parsed(parsed, front.understand(parsed.text, Context(), waiting), reads_back)


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
