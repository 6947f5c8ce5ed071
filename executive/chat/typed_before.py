"""Lines that were typed in chats before, in a file that only its user may read."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Sequence
from pathlib import Path

from executive.chat.input_line import MOST_REMEMBERED

_MOST_BYTES = 200_000


class TypedBefore:
    """The newest lines that were typed, kept in a file.

    Args:
        file: Where.
    """

    def __init__(self, file: Path) -> None:
        self._file = file

    def lines(self) -> list[str]:
        """The lines, the oldest first; none where there is no such file."""
        try:
            with self._file.open("rb") as stored:
                text = stored.read(_MOST_BYTES).decode("utf-8", "replace")
        except OSError:
            return []
        return [line for line in text.splitlines() if line.strip() and line.isprintable()][-MOST_REMEMBERED:]

    def remember(self, lines: Sequence[str]) -> None:
        """Write the newest lines; where they cannot be, they are forgotten."""
        text = "".join(f"{line}\n" for line in lines[-MOST_REMEMBERED:] if line.isprintable())
        with contextlib.suppress(OSError):
            self._file.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
            made = self._file.with_name(f"{self._file.name}.{os.getpid()}")
            with os.fdopen(os.open(made, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600), "wb") as out:
                out.write(text.encode())
            made.replace(self._file)
