"""Standard input, output and error that a caller has closed, filled up or gone away from.

What is told on the way is no reason to end a robot's task: standard error that cannot be written is silent
from then on. Standard output holds results: the first one that is lost is an ``OutputLostError``.
"""

from __future__ import annotations

import errno
import io
import os
import select
import sys
from typing import IO

import typer

from executive.errors import OutputLostError


def secure_standard_streams() -> None:
    """Have all three streams there, and none of them end the program by an error of its own."""
    for number, mode in enumerate(("r", "w", "w")):
        if _stream(number) is None:
            _fill(number)
            _put(number, open(number, mode, encoding="utf-8", closefd=False))  # noqa: SIM115
    for number, is_result in ((1, True), (2, False)):
        given = _stream(number)
        if isinstance(given, io.TextIOWrapper):
            _put(number, _secured(given, is_result))


def _secured(given: io.TextIOWrapper, is_result: bool) -> IO[str]:
    given.flush()
    raw = _Outlet(given.fileno(), is_result)
    return io.TextIOWrapper(
        io.BufferedWriter(raw),
        encoding=given.encoding,
        errors=given.errors,
        line_buffering=given.line_buffering or not is_result,
    )


class _Outlet(io.RawIOBase):
    """Writes to a descriptor until that fails for the first time; what comes afterwards is dropped."""

    def __init__(self, number: int, is_result: bool) -> None:
        self._number, self._is_result = number, is_result
        self._lost = False

    def writable(self) -> bool:
        return True

    def fileno(self) -> int:
        return self._number

    def isatty(self) -> bool:
        return os.isatty(self._number)

    def write(self, data: object) -> int:
        content = memoryview(data).cast("B")  # type: ignore[arg-type]
        if self._lost:
            return len(content)
        try:
            return self._write(content)
        except OSError as failed:
            self._lost = True
            if self._is_result:
                raise OutputLostError(failed.strerror or str(failed), failed.errno == errno.EPIPE) from None
            return len(content)

    def _write(self, content: memoryview) -> int:
        while True:
            try:
                return os.write(self._number, content)
            except BlockingIOError:  # somebody else has made the terminal or the pipe so
                select.select([], [self._number], [])


def _fill(number: int) -> None:
    """Open nothing in the place of a closed descriptor, for child processes too."""
    try:
        os.fstat(number)
    except OSError:
        opened = os.open(os.devnull, os.O_RDWR)
        if opened == number:
            os.set_inheritable(number, True)
        else:
            os.dup2(opened, number)
            os.close(opened)


def _stream(number: int) -> IO[str] | None:
    return (sys.stdin, sys.stdout, sys.stderr)[number]


def _put(number: int, stream: IO[str]) -> None:
    if number == 0:
        sys.stdin = stream
    elif number == 1:
        sys.stdout = stream
    else:
        sys.stderr = stream


def tell_result(line: str) -> None:
    """Write the result on standard output; where that is lost, say so and keep the exit code of the task."""
    try:
        typer.echo(sayable(line))
    except OutputLostError as lost:
        if not lost.unread:
            typer.echo(f"executive: {lost}; the result: {line}", err=True)


def sayable(line: str) -> str:
    """What standard output can show of a line."""
    encoding = sys.stdout.encoding or "utf-8"
    return line.encode(encoding, "backslashreplace").decode(encoding)
