"""``executive replay --view``: a recorded run in a browser, until a signal ends it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from executive.doors.view.access import HERE, Access, new_token
from executive.doors.view.page_server import PageServer
from executive.doors.view.recording import recorded_again
from executive.doors.view.timeline import Timeline
from executive.ending_signals import taken_by
from executive.exit_codes import ExitCode
from executive.runs.run_search import find_run


def show_again(name: str, record: Path | None, port: int, tell: Callable[[str], None]) -> ExitCode:
    """Run a recorded run again, and show it until a signal ends it.

    Nobody can command anything there, so that no token is asked for.

    Args:
        name: Of the run, as for ``executive replay``.
        record: Folder of the recorded runs, or None.
        port: Of 127.0.0.1.
        tell: Takes lines for people.

    Raises:
        UserError: There is no such run, it cannot be run again, or the port is taken.
    """
    signals: list[int] = []
    run = find_run(name, record)
    with taken_by(signals.append):
        recording, verdict = recorded_again(run, tell)
        for line in verdict.lines():
            tell(line)
        server = PageServer(port, Access(new_token()), run.name)
        timeline = Timeline(server, recording, lambda: bool(signals))
        tell(f"the page is at http://{HERE[0]}:{server.port}/. Ctrl-C ends it.")
        timeline.run()
        server.close()
    return ExitCode.DONE if verdict.difference is None else ExitCode.FAILED
