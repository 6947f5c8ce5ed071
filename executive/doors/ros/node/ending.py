"""How a program that stands on a middleware ends: in order, and within a bounded time whatever hangs.

The teardown of a middleware may wait for a peer that is dead, and hold the interpreter's lock meanwhile.
Neither a thread nor a signal's handler of Python would ever run again then. So the limit is kept by
``faulthandler``, whose watchdog needs no interpreter: it writes where each thread hangs to stderr, and exits.
"""

from __future__ import annotations

import faulthandler
import os
import signal
import sys
import threading

ENDS_WITHIN_S = 10.0


class Ending:
    """The end of a program: asked for by SIGTERM, by SIGINT or by ``ask``; made in the main thread.

    Args:
        within_s: From the moment that it is asked for, the process lives so long at most.
    """

    def __init__(self, within_s: float = ENDS_WITHIN_S) -> None:
        self._within_s = within_s
        self._asked = threading.Event()
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, lambda *_: self.ask())

    @property
    def is_asked(self) -> bool:
        """Whether the program is to end; whatever goes on for long asks this in between."""
        return self._asked.is_set()

    def ask(self) -> None:
        """End the program; the time runs from the first that asks."""
        if not self._asked.is_set():
            faulthandler.dump_traceback_later(self._within_s, exit=True)
            self._asked.set()

    def wait(self) -> None:
        """Wait until the program is to end."""
        self._asked.wait()

    def leave(self) -> None:
        """Exit with 0, past whatever threads and libraries would still do as the interpreter ends."""
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(0)
