"""``python -m executive``, and the console script: nothing is imported before Ctrl-C is answered for.

SIGTERM and SIGHUP mean what Ctrl-C means, for every command.
"""

from __future__ import annotations

import contextlib
import gc
import os
import sys

_CANCELLED = 4
"""As in ``executive.exit_codes``, which is not imported yet."""
_COLLECTIONS = 10_000, 20, 20
"""What is loaded stays: Python's own thresholds looked through it for a quarter of a second."""
_INTERRUPTED = 130
"""Typer's code where Ctrl-C comes before a command has begun."""


def main() -> None:
    """Run the command line; Ctrl-C before it is loaded ends the program without a word."""
    gc.set_threshold(*_COLLECTIONS)
    try:
        from executive.ending_signals import interrupt_by_all

        interrupt_by_all()
        from executive.cli.app import main as run

        run()
    except KeyboardInterrupt:
        _cancelled()
    except SystemExit as ended:
        if ended.code in (_CANCELLED, _INTERRUPTED):
            _cancelled()
        raise


def _cancelled() -> None:
    """End at once: Python ends itself by a signal in place of a code where Ctrl-C struck in some imports."""
    for stream in (sys.stdout, sys.stderr):
        with contextlib.suppress(Exception):
            stream.flush()
    os._exit(_CANCELLED)


if __name__ == "__main__":
    main()
