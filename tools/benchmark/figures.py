"""A figure of a benchmark, and how it is shown."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from rich.console import Console
from rich.table import Table


@dataclass(frozen=True, slots=True)
class Figure:
    """One figure.

    Attributes:
        name: What was measured, with its unit.
        ours: The median.
        peer: What it is compared to, or None.
        peer_value: The peer's median from the same interleaved run, or None.
        spread: Ratio of the 95th percentile to the median: the machine's noise and the task's.
    """

    name: str
    ours: float
    peer: str | None
    peer_value: float | None
    spread: float

    @property
    def ratio(self) -> float | None:
        """Ours over the peer's."""
        return None if not self.peer_value else self.ours / self.peer_value

    def to_json(self) -> dict[str, Any]:
        """As the command-line contract writes a figure."""
        return {**asdict(self), "ratio": self.ratio}


def figure(
    name: str, samples: Sequence[float], peer: str | None = None, peer_samples: Sequence[float] = ()
) -> Figure:
    """Make a figure from samples."""
    median, high = np.percentile(samples, (50, 95))
    peer_value = float(np.median(peer_samples)) if len(peer_samples) else None
    return Figure(name, float(median), peer, peer_value, float(high / median) if median else 0.0)


def timed_s(call: Callable[[], object]) -> float:
    """Processor time of one call: wall time on an idle core, and the same on a busy one."""
    began_s = time.process_time()
    call()
    return time.process_time() - began_s


def print_figures(suite: str, figures: Sequence[Figure], console: Console) -> None:
    """Print a table."""
    table = Table("", "ours", "peer", "its value", "ratio", "p95 / median", title=suite)
    for item in figures:
        peer_value = "" if item.peer_value is None else f"{item.peer_value:.4g}"
        ratio = "" if item.ratio is None else f"{item.ratio:.2f}"
        table.add_row(item.name, f"{item.ours:.4g}", item.peer or "", peer_value, ratio, f"{item.spread:.2f}")
    console.print(table)
