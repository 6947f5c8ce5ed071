"""``python -m tools.evaluate survive WHAT``: kill something in the middle of a suite, and count the losses.

The suite runs twice on the same seeds: once by processes and left alone, once with kills. Every episode has
to be recorded once in both, with the same record but for how quick the machine was.
"""

from __future__ import annotations

import argparse
import json
import tempfile
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path

import numpy as np
from rich.console import Console
from rich.table import Table

from executive.errors import UserError
from executive.exit_codes import ExitCode
from tools.evaluate.survival.same_records import Survived, survived
from tools.evaluate.survival.ways import WAYS, Ordered, run_alone

SURVIVE = "survive"
_USUAL = {"workers": (64, 20), "machine": (64, 1), "evaluation": (200, 20)}
"""Of each way: how many episodes, and how many kills."""


def main(arguments: Sequence[str]) -> int:
    """Kill something; 0 when nothing was lost, doubled or changed, 1 when it was, 2 where it could not be."""
    options = _options(arguments)
    messages = Console(stderr=True)
    episodes, kills = _USUAL[options.what]
    ordered = Ordered(
        options.suite,
        options.episodes or episodes,
        options.seed,
        options.jobs,
        kills if options.kills is None or options.what == "machine" else options.kills,
        np.random.default_rng(options.seed),
        lambda line: messages.print(line, markup=False),
    )
    with tempfile.TemporaryDirectory() as folder:
        alone = options.alone or Path(folder) / "alone.jsonl"
        killed = Path(folder) / "killed.jsonl"
        try:
            count = WAYS[options.what](ordered, killed)
            run_alone(ordered, alone)
            found = survived(alone, killed)
        except UserError as wrong:
            messages.print(f"error: {wrong}", style="bold", markup=False)
            return 2
        except KeyboardInterrupt as ended:
            messages.print(str(ended) or "cancelled from the keyboard", markup=False)
            return ExitCode.CANCELLED
    Console().print(_table(options.what, ordered, count, found))
    if options.json is not None:
        document = {"what": options.what, "suite": options.suite, "kills": count, **asdict(found)}
        options.json.write_text(json.dumps(document, indent=1) + "\n", "utf-8")
    return 0 if found.whole and count == ordered.kills else 1


def _table(what: str, ordered: Ordered, count: int, found: Survived) -> Table:
    table = Table(
        "", "measured", "demanded", title=f"{ordered.suite}: {found.wanted} episodes, {what} killed"
    )
    table.add_row("kills", str(count), str(ordered.kills))
    table.add_row("recorded once", str(found.recorded), str(found.wanted))
    table.add_row("recorded twice", str(len(found.doubled)), "0")
    table.add_row("lost", str(len(found.lost)), "0")
    table.add_row("other record than left alone", str(len(found.other)), "0")
    table.add_row("processes that died in episodes", str(found.died), "")
    for order in (*found.doubled, *found.lost, *found.other)[:10]:
        table.add_row("not so", order, "")
    return table


def _options(arguments: Sequence[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog=f"python -m tools.evaluate {SURVIVE}",
        description="Kill something in the middle of a suite, and compare with the same left alone.",
    )
    parser.add_argument("what", choices=WAYS, help="workers and machine of a Ray cluster, or the evaluation")
    parser.add_argument("--suite", default="wave", help="whose episodes (wave)")
    parser.add_argument("--episodes", type=int, help="how many (64; of the evaluation 200)")
    parser.add_argument("--kills", type=int, help="how often (20)")
    parser.add_argument("--seed", type=int, default=0, help="of the first episode, and of the kills")
    parser.add_argument("--jobs", type=int, default=2, help="processes")
    parser.add_argument(
        "--alone", type=Path, metavar="FILE", help="keep what was left alone, or take it from here"
    )
    parser.add_argument("--json", type=Path, metavar="FILE", help="write the figures here")
    return parser.parse_args(arguments)
