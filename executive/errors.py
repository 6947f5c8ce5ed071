"""Errors of the executive package.

ExecutiveError
└── UserError            something the user gave or the machine lacks; one line says what to do, exit code 2
    ├── NotWritableError     a folder or file that cannot be written
    ├── UnknownRunError      a recorded run that is not there
    ├── ScriptError          a task script that cannot be one: file, key and reason
    ├── TrajectoryFileError  a stored trajectory that cannot be one: file, place and reason
    ├── VocabularyError      a list of words that cannot be one: file, word class and reason
    ├── OutputLostError      a result that cannot be written on standard output
    └── MissingPartError     a library or program that an option needs is not installed

What a sentence means, a question and a refusal are return values, not errors.
"""

from __future__ import annotations

import difflib
from collections.abc import Sequence
from pathlib import Path


class ExecutiveError(Exception):
    """Base of every error that the executive package raises."""


class UserError(ExecutiveError):
    """Something that the user gave or the machine lacks; its message is one clear line."""


class NotWritableError(UserError):
    """A folder or file that cannot be written."""

    def __init__(self, path: Path, failed: OSError, hint: str = "choose a place that you may write") -> None:
        super().__init__(f"cannot write {path}: {failed.strerror or failed}; {hint}")


class UnknownRunError(UserError):
    """A recorded run that is not there; ``looked`` is where it was looked for."""

    def __init__(self, name: str, known: Sequence[str], looked: Sequence[Path] = ()) -> None:
        close = difflib.get_close_matches(name, known, n=1, cutoff=0.3)
        hint = f"; the nearest is {close[0]!r}" if close else f"; {len(known)} runs are recorded"
        where = f" in {', '.join(map(str, looked))}; a run's folder can be given as well" if looked else ""
        super().__init__(f"no recorded run {name!r}{hint}{where}")


class ScriptError(UserError):
    """A task script that cannot be read or understood: file, key and reason."""

    def __init__(self, source: str, key: str, reason: str) -> None:
        super().__init__(f"{source}: {key}: {reason}" if key else f"{source}: {reason}")


class TrajectoryFileError(UserError):
    """A stored trajectory that cannot be read: file, place and reason."""

    def __init__(self, path: Path, reason: str) -> None:
        super().__init__(f"{path}: {reason}")


class OutputLostError(UserError):
    """A result that cannot be written on standard output; ``unread``: who was to read it has gone."""

    def __init__(self, reason: str, unread: bool) -> None:
        super().__init__(f"cannot write on standard output: {reason}")
        self.unread = unread


class MissingPartError(UserError):
    """A library or program that an option needs is not installed."""


class VocabularyError(UserError):
    """A list of words that cannot be used: file, word class and reason."""
