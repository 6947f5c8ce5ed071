"""``executive export``: recorded runs as files for other programs."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer


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
