"""``executive replay``: a recorded run again, compared event by event."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from executive.exit_codes import ExitCode


def replay(
    run: Annotated[
        str, typer.Argument(metavar="[RUN]", help="A run's name or folder; the latest by default.")
    ] = "latest",
    record: Annotated[Path | None, typer.Option(metavar="DIR", help="Folder of the recorded runs.")] = None,
) -> None:
    """Run a recorded run again, and tell the first event that differs."""
    from executive.runs.replay import replay as run_again
    from executive.runs.run_search import find_run

    verdict = run_again(find_run(run, record), lambda line: typer.echo(line, err=True))
    for line in verdict.lines():
        typer.echo(line)
    raise typer.Exit(ExitCode.DONE if verdict.difference is None else ExitCode.FAILED)
