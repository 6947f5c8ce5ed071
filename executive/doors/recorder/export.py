"""Makes the motion of runs that were recorded without it: a run in lockstep is carried out once more."""

from __future__ import annotations

from collections.abc import Callable
from datetime import datetime
from pathlib import Path

from executive.doors.recorder.feed import RunFeed
from executive.doors.recorder.mend import mend
from executive.doors.recorder.parts import MotionParts
from executive.errors import NotWritableError, UserError
from executive.runs.replay import replay
from executive.runs.run_log import RecordedRun
from executive.screens.display import NoDisplay

_NS = 1_000_000_000


class NotExportedError(UserError):
    """A run that has no motion, and none can be made."""


def export(run: RecordedRun, tell: Callable[[str], None]) -> list[Path]:
    """See to it that the motion of a run is there; returns the files that hold it.

    Files that were cut off get their ends. What is not there is made by carrying the run out once more, which
    only a run in lockstep allows; it is as it was only where all its events come again.

    Args:
        run: The run.
        tell: Hears what is done.

    Raises:
        NotExportedError: It was carried out live and not recorded in motion, or it does not come again.
        UnreadableRecordingError: What is there is no recording.
        NotWritableError: Its folder cannot be written.
    """
    parts = MotionParts(run.path).all()
    try:
        for part in parts:
            if mend(part):
                tell(f"{part.name} was cut off: its end is written")
        return parts or [_made(run, tell)]
    except OSError as failed:
        raise NotWritableError(run.path, failed) from failed


def _made(run: RecordedRun, tell: Callable[[str], None]) -> Path:
    if run.header.get("live"):
        raise NotExportedError(
            f"run {run.name} was carried out live, and its motion was not recorded: "
            "`executive serve --record DIR` does that; its events are in events.jsonl"
        )
    path, complaints = MotionParts(run.path).next(), list[str]()
    making = path.with_name(f".{path.name}.making")
    making.unlink(missing_ok=True)
    feed = RunFeed(NoDisplay(), complaints.append)
    feed.open(making, run.header, _began_ns(run))
    try:
        verdict = replay(run, tell, feed, feed.begin)
    finally:
        feed.close()
    try:
        if complaints:
            raise NotExportedError(f"run {run.name}: {complaints[0]}")
        if verdict.difference is not None:
            differs = " ".join(line.strip() for line in verdict.lines())
            raise NotExportedError(f"run {run.name} does not come again as it was: {differs}")
        if not making.exists():
            raise NotExportedError(f"run {run.name} holds no motion: nothing was carried out")
        return making.replace(path)
    finally:
        making.unlink(missing_ok=True)


def _began_ns(run: RecordedRun) -> int:
    """Wall time since 1970 at which it began; 0 where it does not say."""
    try:
        return round(datetime.fromisoformat(str(run.header.get("started"))).timestamp()) * _NS
    except ValueError:
        return 0
