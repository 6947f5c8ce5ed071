"""``executive runs`` and ``executive export``: the recorded runs, and files for other programs of them."""

from __future__ import annotations

from enum import StrEnum
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


class FormatChoice(StrEnum):
    """What kind of file."""

    MCAP = "mcap"


def export(
    runs: Annotated[
        list[str] | None,
        typer.Argument(metavar="[RUN]...", help="Names or folders of runs; the latest by default."),
    ] = None,
    format_: Annotated[FormatChoice, typer.Option("--format", help="What kind of file.")] = FormatChoice.MCAP,
    record: Annotated[Path | None, typer.Option(metavar="DIR", help="Folder of the recorded runs.")] = None,
) -> None:
    """Make files for other programs of recorded runs, in their folders."""
    from executive.doors.companion import require_extra
    from executive.runs.run_search import find_run

    require_extra("record", "mcap", "cyclonedds")
    from executive.doors.recorder.export import export as make

    del format_  # there is one
    for run in [find_run(name, record) for name in runs or ["latest"]]:
        for path in make(run, lambda line: typer.echo(line, err=True)):
            typer.echo(path)
