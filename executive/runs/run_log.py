"""Recorded runs: a folder each, with what was asked, every event, and the report.

``run.json`` says what was asked of which robot in which scene, ``scene.toml``, ``script.toml`` and
``config.toml`` are copies of the scene's, the script's and the ``--config`` file, ``events.jsonl`` holds the
canonical events, ``report.json`` the report,
``trajectories``, where they were asked for, the motions that the checker judged, and ``pictures`` what the
camera showed of things that a person was asked about.

Each event is handed to the operating system as soon as it is written, so that a program that is killed
loses none of them; only the last line may be torn, and is left out when the log is read.
"""

from __future__ import annotations

import base64
import contextlib
import json
import shutil
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import Any, TextIO

from executive.errors import NotWritableError, UnknownRunError
from executive.session.events import Event, EventDigest, canonical_line
from robots.clock import utc_timestamp
from trees.events import ThingPictured

LATEST = "latest"
EVENTS = "events.jsonl"
PICTURES = "pictures"
_MOST_OF_NAME = 40
_ELSEWHERE = "choose a folder that you may write with --record"


class RunLog:
    """Writes the record of one run; the digest goes on even when nothing more can be written.

    Attributes:
        digest: Of the events so far.
        path: The run's folder.
        complaint: What could not be written, or None.
        pictures: Those that were kept, as paths within the folder.

    Raises:
        NotWritableError: The folder cannot be made or written.
    """

    def __init__(
        self,
        directory: Path,
        header: Mapping[str, Any],
        scene_file: Path | None = None,
        script_file: Path | None = None,
        config_file: Path | None = None,
    ) -> None:
        self.digest = EventDigest()
        self.complaint: str | None = None
        self._motions = 0
        self.pictures: tuple[str, ...] = ()
        when = utc_timestamp()
        try:
            self.path = _new_folder(directory, when.replace(":", "-"))
            _write_json(self.path / "run.json", {"started": when, **header})
            if scene_file is not None:
                shutil.copyfile(scene_file, self.path / "scene.toml")
            if script_file is not None:
                shutil.copyfile(script_file, self.path / "script.toml")
            if config_file is not None:
                shutil.copyfile(config_file, self.path / "config.toml")
            self._file: TextIO = (self.path / EVENTS).open("w", encoding="utf-8", buffering=1)
        except OSError as failed:
            raise NotWritableError(directory, failed, _ELSEWHERE) from failed

    @property
    def name(self) -> str:
        """The run's name: the time at which it began."""
        return self.path.name

    def __enter__(self) -> RunLog:
        """Begin to write."""
        return self

    def __exit__(
        self, kind: type[BaseException] | None, raised: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Close the file."""
        with contextlib.suppress(OSError):
            self._file.close()

    def add(self, event: Event) -> None:
        """Write one event down; a disk that fills up must not disturb the robot."""
        self.digest.add(event)
        if self.complaint is None:
            try:
                self._file.write(canonical_line(event) + "\n")
            except OSError as failed:
                self.complaint = f"the run's log broke off: {failed.strerror or failed}"
        if isinstance(event, ThingPictured):
            self._add_picture(event)

    def add_motion(self, text: str, verdict: str) -> None:
        """Store a judged motion, as ``executive check`` reads it, under its number and verdict."""
        folder = self.path / "trajectories"
        self._motions += 1
        if self.complaint is None:
            try:
                folder.mkdir(exist_ok=True)
                (folder / f"{self._motions:03d}_{verdict}.json").write_text(text, "utf-8")
            except OSError as failed:
                self.complaint = f"a trajectory could not be stored: {failed.strerror or failed}"

    def _add_picture(self, event: ThingPictured) -> None:
        what = "".join(letter if letter.isalnum() else "_" for letter in event.what)[:_MOST_OF_NAME]
        name = f"{PICTURES}/{len(self.pictures) + 1:03d}_{what}.png"
        try:
            (self.path / PICTURES).mkdir(exist_ok=True)
            (self.path / name).write_bytes(base64.b64decode(event.png_base64))
        except OSError as failed:
            self.complaint = self.complaint or f"a picture could not be kept: {failed.strerror or failed}"
        else:
            self.pictures = (*self.pictures, name)

    def finish(self, report: Mapping[str, Any]) -> None:
        """Write the report; what goes wrong now is a complaint, because the robot has moved already."""
        try:
            _write_json(self.path / "report.json", report)
            self._file.flush()
        except OSError as failed:
            self.complaint = self.complaint or f"the run was not kept whole: {failed.strerror or failed}"


@dataclass(frozen=True, slots=True)
class RecordedRun:
    """A run on disk; ``report`` is empty when it was cut off."""

    path: Path
    header: Mapping[str, Any]
    report: Mapping[str, Any]

    @property
    def name(self) -> str:
        """The run's name: that of its folder."""
        return self.path.name


def recorded_runs(directory: Path) -> list[RecordedRun]:
    """All runs in a folder, the oldest first; folders that are none are passed over."""
    if not directory.is_dir():
        return []
    found = (_read(path) for path in sorted(directory.iterdir()))
    return [run for run in found if run is not None]


def run_in(folder: Path) -> RecordedRun | None:
    """The run that a folder holds, or None when it is no run's folder."""
    return _read(folder.resolve())


def recorded_run(directory: Path, name: str) -> RecordedRun:
    """One run by its name, or the latest.

    Raises:
        UnknownRunError: There is none of that name.
    """
    runs = recorded_runs(directory)
    if name == LATEST and runs:
        return runs[-1]
    for run in runs:
        if run.name == name:
            return run
    raise UnknownRunError(name, [run.name for run in runs])


def recorded_events(path: Path) -> list[dict[str, Any]]:
    """The events of a run's folder, in order; a line that was torn off at the end is left out.

    Raises:
        OSError: There is no log to read.
        ValueError: A line other than the last one is no event: the file was damaged.
    """
    lines = (path / EVENTS).read_text("utf-8", errors="replace").split("\n")
    events = []
    for number, line in enumerate(lines, start=1):
        if not line:
            continue
        try:
            event = json.loads(line)
        except ValueError as torn:
            if number == len(lines):  # what follows the last line break was not written to its end
                break
            raise ValueError(f"{path / EVENTS}, line {number}: {torn}") from torn
        events.append(event)
    return events


def write_report(path: Path, report: Mapping[str, Any]) -> None:
    """Write a report where the user asked for it.

    Raises:
        NotWritableError: It cannot be written there.
    """
    try:
        _write_json(path, report)
    except OSError as failed:
        raise NotWritableError(path, failed) from failed


def require_writable(path: Path) -> None:
    """Find out before anything moves whether a file can be written; leaves no trace.

    Raises:
        NotWritableError: It cannot.
    """
    existed = path.exists()
    try:
        with path.open("ab"):
            pass
        if not existed:
            path.unlink()
    except OSError as failed:
        raise NotWritableError(path, failed) from failed


def require_recordable(directory: Path) -> None:
    """Find out before anything moves whether runs can be recorded in a folder; makes the folder.

    Raises:
        NotWritableError: They cannot.
    """
    try:
        directory.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=directory) as file:
            file.write(b"{}")
    except OSError as failed:
        raise NotWritableError(directory, failed, _ELSEWHERE) from failed


def _new_folder(directory: Path, stem: str) -> Path:
    directory.mkdir(parents=True, exist_ok=True)
    for number in range(1, 1000):
        path = directory / (stem if number == 1 else f"{stem}.{number:03d}")
        try:
            path.mkdir()
        except FileExistsError:
            continue
        return path
    raise FileExistsError(f"{directory / stem}: too many runs in one second")


def _read(path: Path) -> RecordedRun | None:
    header = _read_json(path / "run.json")
    if header is None:
        return None
    return RecordedRun(path, header, _read_json(path / "report.json") or {})


def _read_json(path: Path) -> dict[str, Any] | None:
    try:
        document = json.loads(path.read_text("utf-8"))
    except (OSError, ValueError):
        return None
    return document if isinstance(document, dict) else None


def _write_json(path: Path, document: Mapping[str, Any]) -> None:
    path.write_text(json.dumps(document, indent=2) + "\n", encoding="utf-8")
