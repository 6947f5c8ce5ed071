"""Time in which a task was paused: it counts towards no deadline."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(slots=True)
class Pauses:
    """Adds up pauses; whoever runs the tasks writes it, deadlines read it.

    Attributes:
        total_s: Seconds on the injected clock, since the beginning, in which trees were not ticked.
    """

    total_s: float = 0.0
