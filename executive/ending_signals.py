"""Signals that ask the program to end: Ctrl-C, SIGTERM, and SIGHUP, of which all mean the same.

SIGHUP says that the terminal has gone. A shell and the kernel may both say so: it counts once. Where whoever
started the program has it ignore SIGHUP (``nohup``), that stays so.
"""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType

_ENDING = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


class EndedBySignal(KeyboardInterrupt):
    """A signal asked the program to end, and nothing is under way that has to be ended in order first."""


def told(number: int, done: str) -> str:
    """What a signal did, for people: "cancelled from the keyboard", "cancelled by SIGTERM"."""
    if number == signal.SIGINT:
        return f"{done} from the keyboard"
    return f"{done} by {signal.Signals(number).name}"


def interrupt_by_all() -> None:
    """Let each of them end the program as Ctrl-C does, from now on."""
    for number in _ENDING:
        if number != signal.SIGINT and _is_heard(number):
            signal.signal(number, _interrupt)


@contextmanager
def taken_by(take: Callable[[int], None]) -> Iterator[None]:
    """Have a function called with the number of each such signal instead.

    Signals reach the main thread alone: in another one nothing is changed.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return

    def took(number: int, _frame: FrameType | None) -> None:
        if number == signal.SIGHUP:
            signal.signal(signal.SIGHUP, signal.SIG_IGN)
        take(number)

    before = {number: signal.getsignal(number) for number in _ENDING if _is_heard(number)}
    for number in before:
        signal.signal(number, took)
    try:
        yield
    finally:
        for number, handler in before.items():
            if signal.getsignal(number) is took:
                signal.signal(number, handler)


def _is_heard(number: int) -> bool:
    return number != signal.SIGHUP or signal.getsignal(number) is not signal.SIG_IGN


def _interrupt(number: int, _frame: FrameType | None) -> None:
    if number == signal.SIGHUP:
        signal.signal(signal.SIGHUP, signal.SIG_IGN)
    raise EndedBySignal(told(number, "cancelled"))
