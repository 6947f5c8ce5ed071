"""``executive replay --view``: a recorded run in a browser, until a signal ends it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import ModuleType

from executive.doors.companion import require_extra
from executive.doors.recorder.parts import SUFFIX, MotionParts
from executive.doors.view.access import Access, new_token
from executive.doors.view.page_server import PageServer
from executive.doors.view.recording import Recording, recorded_again
from executive.doors.view.timeline import Timeline
from executive.ending_signals import taken_by
from executive.errors import UserError
from executive.exit_codes import ExitCode
from executive.runs.run_search import find_run


def show_again(
    name: str, record: Path | None, port: int, tell: Callable[[str], None], beside: str | None = None
) -> ExitCode:
    """Show a recorded run, or two beside each other, until a signal ends it.

    Where its motion was recorded that is shown; else it is carried out once more. Nobody can command
    anything there, so that no token is asked for.

    Args:
        name: Of the run, as for ``executive replay``, or an MCAP file.
        record: Folder of the recorded runs, or None.
        port: Of 127.0.0.1.
        tell: Takes lines for people.
        beside: Another run; None for none.

    Raises:
        UserError: There is no such run, it cannot be run again, or the port is taken.
    """
    signals: list[int] = []
    with taken_by(signals.append):
        recording, is_same = _recording(name, record, tell)
        other = None
        if beside is not None:
            other, is_other_same = _recording(beside, record, tell)
            is_same = is_same and is_other_same
        server = PageServer(port, Access(new_token()), recording.name)
        timeline = Timeline(server, recording, lambda: bool(signals), other)
        tell(f"the page is at {timeline.address}. Ctrl-C ends it.")
        timeline.run()
        server.close()
    return ExitCode.DONE if is_same else ExitCode.FAILED


def _recording(name: str, record: Path | None, tell: Callable[[str], None]) -> tuple[Recording, bool]:
    """A run to look at, and whether it is as it was recorded."""
    if Path(name).suffix == SUFFIX:
        return _motion_read().recording_in(Path(name)), True
    run = find_run(name, record)
    if MotionParts(run.path).all():
        try:
            return _motion_read().recording_of(run), True
        except UserError as unreadable:
            if run.header.get("live"):
                raise
            tell(f"{unreadable}; it is carried out once more")
    recording, verdict = recorded_again(run, tell)
    for line in verdict.lines():
        tell(line)
    return recording, verdict.difference is None


def _motion_read() -> ModuleType:
    """The reader of recorded motion."""
    require_extra("record", "mcap", "cyclonedds")
    from executive.doors.view import motion_read

    return motion_read
