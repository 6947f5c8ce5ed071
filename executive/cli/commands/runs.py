"""``executive runs``: the recorded runs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from executive.errors import UserError


def runs(
    record: Annotated[Path | None, typer.Option(metavar="DIR", help="Folder of the recorded runs.")] = None,
) -> None:
    """List recorded runs: when, what, outcome, duration."""
    from executive.runs.run_search import find_runs, folders

    if record is not None and not record.is_dir():
        raise UserError(f"{record}: {'is no folder' if record.exists() else 'there is no such folder'}")
    found = find_runs(record)
    looked = folders(record)
    if not found:
        typer.echo(f"no runs are recorded in {', '.join(map(str, looked))}", err=True)
    for run in found:
        tasks = run.report.get("tasks", ())
        simulated_s = sum(task["time_s"]["simulated"] for task in tasks)
        outcome = run.report.get("outcome", "cut off")
        elsewhere = f"  in {run.path.parent}" if run.path.parent != looked[0] else ""
        said = run.header.get("input", "")
        typer.echo(f"{run.name:<22} {outcome:<10} {simulated_s:7.1f} s  {said!r}{elsewhere}")
