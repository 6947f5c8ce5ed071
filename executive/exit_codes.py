"""What the exit status of a command means."""

from __future__ import annotations

from enum import IntEnum


class ExitCode(IntEnum):
    """Exit codes, as the command-line contract lists them."""

    DONE = 0
    FAILED = 1
    INVALID = 2
    QUESTION = 3
    CANCELLED = 4
    UNSAFE = 5
    DEFECT = 70
