"""``executive replay``: a recorded run again, compared event by event."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from executive.cli.commands.choices import VIEW_PORT, ViewPortOption
from executive.exit_codes import ExitCode


def replay(
    run: Annotated[
        str, typer.Argument(metavar="[RUN]", help="A run's name or folder; the latest by default.")
    ] = "latest",
    other: Annotated[
        str | None, typer.Argument(metavar="[OTHER]", help="With --view: another run, beside it.")
    ] = None,
    record: Annotated[Path | None, typer.Option(metavar="DIR", help="Folder of the recorded runs.")] = None,
    view: Annotated[
        bool, typer.Option("--view", help="Then show it, to scrub through, in a browser.")
    ] = False,
    view_port: ViewPortOption = VIEW_PORT,
) -> None:
    """Run a recorded run again, and tell the first event that differs."""
    if other is not None and not view:
        raise typer.BadParameter("two runs are put beside each other by --view alone")

    def tell(line: str) -> None:
        typer.echo(line, err=True)

    if view:
        from executive.doors.companion import OF_THE_VIEW, require_extra

        require_extra("view", *OF_THE_VIEW)
        from executive.doors.view.shown_again import show_again

        raise typer.Exit(show_again(run, record, view_port, tell, other))
    from executive.runs.replay import replay as run_again
    from executive.runs.run_search import find_run

    verdict = run_again(find_run(run, record), tell)
    for line in verdict.lines():
        typer.echo(line)
    raise typer.Exit(ExitCode.DONE if verdict.difference is None else ExitCode.FAILED)
