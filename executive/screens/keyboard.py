"""Single keys from a terminal, without Enter and without waiting."""

from __future__ import annotations

import contextlib
import os
import select
import termios
import tty
from collections.abc import Callable
from types import TracebackType
from typing import IO

from executive.screens.key_names import key_names
from executive.screens.terminal_attendant import LOOK_EVERY_S, never


class Keyboard:
    """A terminal's keys, one by one, while it is entered as a context; Ctrl-C is still a signal.

    From a terminal that has gone nothing comes any more.

    Raises:
        termios.error: It is no terminal.
    """

    def __init__(self, stdin: IO[str]) -> None:
        self._file = stdin.fileno()
        self._before = termios.tcgetattr(self._file)

    def __enter__(self) -> Keyboard:
        """Listen to single keys."""
        tty.setcbreak(self._file)
        return self

    def __exit__(
        self, kind: type[BaseException] | None, raised: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Leave the terminal as it was found."""
        with contextlib.suppress(termios.error):
            termios.tcsetattr(self._file, termios.TCSADRAIN, self._before)

    def key(self, timeout_s: float | None = 0.0) -> str:
        """The next key, or nothing when none comes in time; None waits for one however long it takes."""
        ready, _, _ = select.select([self._file], [], [], timeout_s)
        return self._read(1) if ready else ""

    def typed(self, timeout_s: float) -> bytes | None:
        """All that has been typed, as soon as there is something; None once the terminal has gone."""
        ready, _, _ = select.select([self._file], [], [], timeout_s)
        if not ready:
            return b""
        try:
            return os.read(self._file, 4096) or None
        except OSError:
            return None

    def keys(self, timeout_s: float = 0.0) -> tuple[str, ...]:
        """The keys that have come, by name: characters, "up", "down", "left", "right", "enter"."""
        ready, _, _ = select.select([self._file], [], [], timeout_s)
        return key_names(self._read(1024)) if ready else ()

    def line(self, timeout_s: float, interrupted: Callable[[], bool] = never) -> str | None:
        """A line typed with echo, or None when none comes in time, or it is not waited for any more."""
        try:
            termios.tcsetattr(self._file, termios.TCSADRAIN, self._before)
        except termios.error:
            return None
        try:
            for _ in range(max(1, round(timeout_s / LOOK_EVERY_S))):
                if interrupted():
                    return None
                ready, _, _ = select.select([self._file], [], [], LOOK_EVERY_S)
                if ready:
                    return self._read(1024).strip()
            return None
        finally:
            with contextlib.suppress(termios.error):
                tty.setcbreak(self._file)

    def _read(self, most: int) -> str:
        try:
            return os.read(self._file, most).decode("utf-8", "replace")
        except OSError:
            return ""
