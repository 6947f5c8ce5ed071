"""What one suite measured: figures with peers, and standings of contests."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from rich.console import Console

from tools.benchmark.contest import Standing, print_standings
from tools.benchmark.figures import Figure, print_figures


@dataclass(frozen=True, slots=True)
class Report:
    """One suite's results.

    Attributes:
        suite: Its name.
        quick: Whether few samples were taken.
        figures: This project's figures, each with its peer.
        standings: How everybody did in a contest.
        notes: What a reader must know beside the numbers, such as peers that were not there.
    """

    suite: str
    quick: bool
    figures: Sequence[Figure]
    standings: Sequence[Standing] = ()
    notes: Sequence[str] = ()

    def to_json(self) -> dict[str, Any]:
        """As the command-line contract writes a suite, with what contests add."""
        return {
            "suite": self.suite,
            "quick": self.quick,
            "figures": [item.to_json() for item in self.figures],
            "standings": [item.to_json() for item in self.standings],
            "notes": list(self.notes),
        }

    def print(self, console: Console) -> None:
        """Print tables."""
        if self.figures:
            print_figures(self.suite, self.figures, console)
        if self.standings:
            print_standings(self.suite, self.standings, console)
        for note in self.notes:
            console.print(note)


def contest_figures(name: str, standings: Sequence[Standing]) -> list[Figure]:
    """The first planner's time over all problems, beside each of the others'."""
    families = [item.family for item in standings]
    of_all = [item for item in standings if item.family == families[-1]]
    ours, peers = of_all[0], of_all[1:]
    if ours.median_ms is None or ours.p95_ms is None:
        return []
    spread = ours.p95_ms / ours.median_ms
    return [Figure(name, ours.median_ms, peer.planner, peer.median_ms, spread) for peer in peers]
