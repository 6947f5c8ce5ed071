"""``executive why``: the failure chain of a recorded run."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from executive.errors import UserError


def why(
    run: Annotated[
        str, typer.Argument(metavar="[RUN]", help="A run's name or folder; the latest by default.")
    ] = "latest",
    record: Annotated[Path | None, typer.Option(metavar="DIR", help="Folder of the recorded runs.")] = None,
    full: Annotated[bool, typer.Option("--full", help="Every link of the failure chain as well.")] = False,
) -> None:
    """Say why a run ended as it did."""
    from executive.reports.explanation import explained
    from executive.reports.feedback import failure_lines
    from executive.runs.recorded_failure import failure_from
    from executive.runs.run_search import find_run

    recorded = find_run(run, record)
    typer.echo(f"run {recorded.name}: {recorded.header.get('input', '')!r}")
    if not recorded.report:
        raise UserError(f"run {recorded.name} was cut off before its report; its events are in events.jsonl")
    typer.echo(str(recorded.report.get("message", recorded.report.get("outcome", ""))))
    for task in recorded.report.get("tasks", ()):
        if task.get("failure") is None:
            continue
        failure = failure_from(task["failure"])
        typer.echo(f"{task.get('text', '')!r} {task.get('outcome', '')}")
        for line in explained(failure):
            typer.echo(f"  {line}")
        if full:
            typer.echo("  the whole chain:")
            for line in failure_lines(failure):
                typer.echo(f"    {line}")
