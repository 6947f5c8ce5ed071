"""What the kernel says of a process: whether it wants to run, and how much it could."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

_PROC = Path("/proc")
_WANTS = ("R", "D")
"""Runnable, or waiting for a page or a disk: not its own will."""


@dataclass(frozen=True, slots=True)
class ProcessorUse:
    """The main thread of a process.

    Attributes:
        wants_to_run: Whether it is running, or kept from it by the machine alone; one that sleeps, was
            stopped or has ended does not want to.
        ran_s: Processor time that it had so far.
    """

    wants_to_run: bool
    ran_s: float


def processor_use(pid: int, proc: Path = _PROC) -> ProcessorUse | None:
    """Read it, or None where the kernel does not tell; see proc(5), ``stat`` and ``schedstat``."""
    try:
        stat = (proc / str(pid) / "stat").read_text("ascii", "replace")
        ran_ns = int((proc / str(pid) / "schedstat").read_text("ascii").split()[0])
        state = stat[stat.rindex(")") + 1 :].split()[0]  # the name before it may hold anything
    except (OSError, ValueError, IndexError):
        return None
    return ProcessorUse(state in _WANTS, 1e-9 * ran_ns)
