"""What the exit status of a command means."""

from __future__ import annotations

from enum import IntEnum


class ExitCode(IntEnum):
    """Exit codes, as the command-line contract lists them.

    ``UNREAD`` is a shell's code of a program that SIGPIPE ended: who was to read the output has gone.
    """

    DONE = 0
    FAILED = 1
    INVALID = 2
    QUESTION = 3
    CANCELLED = 4
    UNSAFE = 5
    DEFECT = 70
    UNREAD = 141
