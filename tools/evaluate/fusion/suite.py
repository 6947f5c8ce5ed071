"""The suite of senses that disagree: as many picks with something planted as without."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from rich.console import Console

from tools.evaluate.fusion.episode import OWN_M, USUAL_M, FusionOrder, died, run_fusion
from tools.evaluate.fusion.record import FusionRecord, FusionSummary
from tools.evaluate.record_suite import run_record_suite

FUSION_SUITE = "fusion"
_APART = 100_000
"""Between the seeds of picks with and without, so that no scene comes twice."""


def run_fusion_suite(options: argparse.Namespace, messages: Console) -> int:
    """Run the suite; 0 when every demand is met. ``--episodes N`` is N picks with and N without."""
    own_m = OWN_M if options.own is None else 1e-3 * options.own
    if not 0.0 < own_m <= USUAL_M:
        messages.print(f"error: --own must be above 0 and at most {1e3 * USUAL_M:g} mm", style="bold")
        return 2
    orders = [
        FusionOrder(options.seed + i + (0 if planted else _APART), planted, own_m, options.robot)
        for i in range(options.episodes)
        for planted in (True, False)
    ]

    def summarise(records: Sequence[FusionRecord]) -> FusionSummary:
        return FusionSummary(options.seed, own_m, records)

    return run_record_suite(
        "picks with and without a planted disagreement",
        orders,
        run_fusion,
        died,
        summarise,
        line=_line,
        place=lambda record: (record.seed,),
        execution=options.execution,
        document=options.json,
        messages=messages,
    )


def _line(record: FusionRecord) -> str:
    faults = f" {', '.join(record.faults).upper()}" if record.faults else ""
    noticed = ", ".join(record.noticed) or "nothing"
    return (
        f"seed {record.seed} {record.planted}: noticed {noticed}; {record.outcome}, "
        f"held {record.truth}, {record.attempts} attempts{faults} {record.failure}{record.error or ''}"
    )
