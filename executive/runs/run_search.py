"""Where recorded runs are looked for: the usual folder, every other one that runs were recorded in, a path.

Folders that ``--record`` named are noted in a list of this user's, so that ``runs``, ``why`` and ``replay``
find what is in them; a folder that is gone is passed over.
"""

from __future__ import annotations

import contextlib
import json
from pathlib import Path

from executive.config import data_directory, runs_directory
from executive.errors import UnknownRunError, UserError
from executive.runs.run_log import LATEST, RecordedRun, recorded_runs, run_in

_MOST = 50
"""Folders that are remembered; the oldest is forgotten first."""


def note_folder(folder: Path) -> None:
    """Remember a folder in which a run was recorded; that it cannot be noted is no reason to fail."""
    with contextlib.suppress(OSError):
        own = folder.resolve()
        if own == runs_directory().resolve():
            return
        known = [path for path in _noted() if path != own]
        listed = [str(path) for path in [*known, own][-_MOST:]]
        file = _list()
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(json.dumps(listed, indent=2) + "\n", "utf-8")


def folders(record: Path | None = None) -> list[Path]:
    """Where runs are looked for: the folder that is given, else the usual one and those that were noted."""
    if record is not None:
        return [record]
    return list(dict.fromkeys([runs_directory(), *(path for path in _noted() if path.is_dir())]))


def find_runs(record: Path | None = None) -> list[RecordedRun]:
    """Every run there, the oldest first."""
    found = [run for folder in folders(record) for run in recorded_runs(folder)]
    return sorted(found, key=lambda run: (str(run.header.get("started", "")), run.name))


def find_run(name: str, record: Path | None = None) -> RecordedRun:
    """One run: by its name, by the path of its folder or of a folder of runs, or the latest.

    Raises:
        UnknownRunError: There is none.
        UserError: The name is empty.
    """
    if not name.strip():
        raise UserError("the name of the run is empty; leave it out for the latest")
    path = Path(name)
    if name != LATEST and path.is_dir():
        own = run_in(path)
        if own is not None:
            return own
        name, record = LATEST, path
    runs = find_runs(record)
    if name == LATEST and runs:
        return runs[-1]
    for run in runs:
        if run.name == name:
            return run
    raise UnknownRunError(name, [run.name for run in runs], folders(record))


def _list() -> Path:
    return data_directory() / "record-folders.json"


def _noted() -> list[Path]:
    try:
        listed = json.loads(_list().read_text("utf-8"))
    except (OSError, ValueError):
        return []
    return [Path(one) for one in listed if isinstance(one, str)] if isinstance(listed, list) else []
