"""``executive runs``: the recorded runs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from executive.config import runs_directory


def runs(
    record: Annotated[Path | None, typer.Option(metavar="DIR", help="Folder of the recorded runs.")] = None,
) -> None:
    """List recorded runs: when, what, outcome, duration."""
    from executive.run_log import recorded_runs

    folder = record or runs_directory()
    found = recorded_runs(folder)
    if not found:
        typer.echo(f"no runs are recorded in {folder}", err=True)
    for run in found:
        tasks = run.report.get("tasks", ())
        simulated_s = sum(task["time_s"]["simulated"] for task in tasks)
        outcome = run.report.get("outcome", "cut off")
        typer.echo(f"{run.name:<22} {outcome:<10} {simulated_s:7.1f} s  {run.header.get('input', '')!r}")
