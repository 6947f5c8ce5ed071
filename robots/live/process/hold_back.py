"""Holds control time back while the commander is kept from running by a machine that is too busy.

A heartbeat that does not come for 1.0 s of control time is a hang, whatever the reason. A simulated world
can wait: while the kernel says that the silent commander wants to run and hardly could, control time
stands still, for a bounded while. One that sleeps, was stopped, or runs without end is not waited for.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from robots.clock import Clock

_PROC = Path("/proc")
_WANTS = ("R", "D")
"""Runnable, or waiting for a page or a disk: not its own will."""


@dataclass(frozen=True, slots=True)
class ProcessorUse:
    """What the kernel tells of a process's main thread.

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


BASE_AFTER_S = 0.1
"""From so much silence on, of control time, the commander's processor time is counted."""
HOLD_AFTER_S = 0.5
"""From so much on, control time may be held back: half a second is left to the watchdog."""
RAN_S = 0.2
"""A tick takes some milliseconds; who ran for so long in one silence is in a loop of its own."""
MOST_S = 5.0
"""Wall time for which one silence is waited for."""


class HoldBack:
    """Decides at each look whether control time is held back for a commander that cannot run."""

    def __init__(self, wall: Clock, use: Callable[[int], ProcessorUse | None]) -> None:
        """Begin.

        Args:
            wall: Wall time.
            use: Tells what a process could run.
        """
        self._wall, self._use = wall, use
        self._ran_s: float | None = None
        self._began_s: float | None = None

    def wanted(self, pid: int | None, silence_s: float) -> bool:
        """Whether control time should stand still now.

        Args:
            pid: The commander's process, or None when nobody has to speak.
            silence_s: Control time since it spoke.
        """
        if pid is None or silence_s < BASE_AFTER_S:
            self._ran_s = self._began_s = None
            return False
        if self._ran_s is not None and silence_s < HOLD_AFTER_S:
            return False
        use = self._use(pid)
        if use is None:
            return False
        if self._ran_s is None:
            self._ran_s = use.ran_s
        if silence_s < HOLD_AFTER_S or not use.wants_to_run or use.ran_s - self._ran_s > RAN_S:
            return False
        if self._began_s is None:
            self._began_s = self._wall.now_s()
        return self._wall.now_s() - self._began_s < MOST_S
