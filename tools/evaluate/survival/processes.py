"""The processes that a program has begun, and those that these have begun, by what the system tells."""

from __future__ import annotations

import contextlib
import os
import signal
from collections import defaultdict
from pathlib import Path

_PROC = Path("/proc")


def below(pid: int) -> dict[int, str]:
    """Everything that one process, or another below it, has begun and that still runs: its command by its id.

    Args:
        pid: Of the process.
    """
    children: dict[int, list[int]] = defaultdict(list)
    for entry in _PROC.iterdir():
        if entry.name.isdecimal() and (parent := _parent(int(entry.name))) is not None:
            children[parent].append(int(entry.name))
    found, left = {}, list(children[pid])
    while left:
        one = left.pop()
        left += children[one]
        command = _command(one)
        if command is not None:
            found[one] = command
    return found


def kill(pid: int) -> bool:
    """Kill a process as nothing can hinder; False where it has ended by itself."""
    with contextlib.suppress(ProcessLookupError):
        os.kill(pid, signal.SIGKILL)
        return True
    return False


def _parent(pid: int) -> int | None:
    try:
        told = (_PROC / str(pid) / "stat").read_text()
    except OSError:
        return None
    state, parent = told.rpartition(")")[2].split()[:2]
    return None if state == "Z" else int(parent)


def _command(pid: int) -> str | None:
    try:
        return (
            (_PROC / str(pid) / "cmdline").read_bytes().replace(b"\0", b" ").decode(errors="replace").strip()
        )
    except OSError:
        return None
