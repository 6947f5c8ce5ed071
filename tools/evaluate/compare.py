"""``python -m tools.evaluate compare A B``: two versions or settings at the same episodes.

``A`` and ``B`` are journals of one suite. Episodes of the same order are compared pair by pair: rates by
McNemar's exact test, times by the bootstrap of the median ratio. What changed is told with the command that
shows it again.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from rich.console import Console
from rich.table import Table

from executive.errors import UserError
from tools.documents.episode_document import EpisodeDocument
from tools.evaluate.harness.journal import episodes_of
from tools.evaluate.harness.statistics import PairedShares, ratio_interval, share_text

COMPARE = "compare"
_SHOWN = 25
_TIMES = ("simulated_s", "planning_ms")
_SEED = 0
_TOLD = ("seed", "robot", "fault", "scene", "perception", "light")
"""What an option says of an order."""


@dataclass(frozen=True, slots=True)
class Pair:
    """One order, run twice."""

    first: EpisodeDocument
    second: EpisodeDocument

    @property
    def changed(self) -> bool:
        """Whether one was good and the other not."""
        return self.first.good != self.second.good


@dataclass(frozen=True, slots=True)
class Comparison:
    """Two journals of one suite, pair by pair.

    Attributes:
        suite: Name of the suite.
        pairs: Episodes that both have.
        alone: Number of episodes that one of them has alone.
    """

    suite: str
    pairs: Sequence[Pair]
    alone: int

    @property
    def shares(self) -> PairedShares:
        """How often each was good."""
        goods = [(pair.first.good, pair.second.good) for pair in self.pairs]
        return PairedShares(
            goods.count((True, True)),
            goods.count((True, False)),
            goods.count((False, True)),
            goods.count((False, False)),
        )

    def times(self) -> Mapping[str, tuple[float, float, float]]:
        """How many times the first the second takes, with an interval, for each kind of time."""
        rng = np.random.default_rng(_SEED)
        found = {}
        for name in (*_TIMES, "wall_s", "processor_s"):
            both = [(_time(pair.first, name), _time(pair.second, name)) for pair in self.pairs]
            both = [(a, b) for a, b in both if a > 0.0 and b > 0.0]
            if len(both) > 1:
                found[name] = ratio_interval([a for a, _ in both], [b for _, b in both], rng)
        return found


def compare(first: Path, second: Path) -> Comparison:
    """Compare two journals.

    Raises:
        UserError: One cannot be read, they are of different suites, or have no episode in common.
    """
    found = [{_key(episode): episode for episode in episodes_of(file)} for file in (first, second)]
    suites = {episode.suite for some in found for episode in some.values()}
    if len(suites) > 1:
        raise UserError(f"{first} and {second} are of different suites: {', '.join(sorted(suites))}")
    shared = [key for key in found[0] if key in found[1]]
    if not shared:
        raise UserError(f"{first} and {second} have no episode in common: run both with the same --seed")
    pairs = [Pair(found[0][key], found[1][key]) for key in shared]
    return Comparison(suites.pop(), pairs, len(found[0]) + len(found[1]) - 2 * len(shared))


def _key(episode: EpisodeDocument) -> str:
    return json.dumps(episode.order, sort_keys=True)


def _time(episode: EpisodeDocument, name: str) -> float:
    if name not in _TIMES:
        return float(getattr(episode.cost, name))
    records = episode.record if isinstance(episode.record, list) else [episode.record]
    return sum(float(record.get(name) or 0.0) for record in records)


def print_comparison(found: Comparison, names: tuple[str, str], console: Console) -> None:
    """Print shares, times, and what changed."""
    shares, count = found.shares, len(found.pairs)
    table = Table("", *names, title=f"{found.suite}: {count} episodes that both have")
    table.add_row(
        "good",
        share_text(shares.both + shares.first, count),
        share_text(shares.both + shares.second, count),
    )
    table.add_row("good here alone", str(shares.first), str(shares.second))
    console.print(table)
    verdict = "no more than chance" if shares.p_value > 0.05 else "more than chance"
    console.print(f"difference: {verdict} (McNemar's exact test, p = {shares.p_value:.3f})")
    for name, (ratio, low, high) in found.times().items():
        console.print(f"{name.replace('_', ' ')}: {ratio:.3f} times ({low:.3f} to {high:.3f})")
    if found.alone:
        console.print(f"{found.alone} episodes are in one of the two alone")
    changed = [pair for pair in found.pairs if pair.changed]
    for pair in changed[:_SHOWN]:
        better = names[0] if pair.first.good else names[1]
        console.print(f"good in {better} alone: {again(pair.first)}", markup=False, soft_wrap=True)
    if len(changed) > _SHOWN:
        console.print(f"and {len(changed) - _SHOWN} more")


def again(episode: EpisodeDocument) -> str:
    """The command that runs an episode again, and what of its order no option says."""
    told = [f"--{key} {episode.order[key]}" for key in _TOLD if episode.order.get(key) is not None]
    rest = {key: value for key, value in episode.order.items() if key not in _TOLD}
    command = " ".join(["python -m tools.evaluate", episode.suite, "--episodes 1 --jobs 1", *told])
    return f"{command}, there {json.dumps(rest)}" if rest else command


def main(arguments: Sequence[str] | None = None) -> int:
    """Compare two journals; 0 when they could be compared, 2 when not."""
    parser = argparse.ArgumentParser(
        prog="python -m tools.evaluate compare", description="Two results of one suite, pair by pair."
    )
    parser.add_argument("first", type=Path, metavar="A", help="a journal, as evaluations keep them")
    parser.add_argument("second", type=Path, metavar="B", help="another one with the same seeds")
    chosen = parser.parse_args(arguments)
    try:
        found = compare(chosen.first, chosen.second)
    except UserError as wrong:
        Console(stderr=True).print(f"error: {wrong}", style="bold", markup=False, soft_wrap=True)
        return 2
    print_comparison(found, (chosen.first.stem, chosen.second.stem), Console())
    return 0
