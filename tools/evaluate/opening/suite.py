"""The suites ``open`` and ``close``: doors with hinges on either side, and drawers; one in four locked."""

from __future__ import annotations

import argparse
import json

from rich.console import Console
from rich.table import Table

from tools.evaluate.opening.episode import OpeningOrder, died, run_opening
from tools.evaluate.opening.records import OpeningRecord, OpeningSummary
from tools.evaluate.workers import run_each

OPENING_SUITES = ("open", "close")


def run_opening_suite(options: argparse.Namespace, messages: Console) -> int:
    """Run it; 0 when every demand is met, 1 when not, 2 for an option that it does not have."""
    if options.fault or options.scene:
        messages.print(f"error: the suite {options.suite} takes no fault and no scene", style="bold")
        return 2
    orders = [OpeningOrder(options.suite, options.seed + i, options.robot) for i in range(options.episodes)]
    records: list[OpeningRecord] = []
    for record in run_each(orders, options.jobs, run_opening, died):
        records.append(record)
        bad = sum(bool(item.faults) for item in records)
        where = f"{record.hinge} {record.kind}".strip() + (" locked" if record.locked else "")
        faults = ", ".join(record.faults) or "well"
        why = (record.failure or record.detail or "")[-200:]
        messages.print(
            f"{len(records)} of {len(orders)}: seed {record.seed} {where} {record.outcome} "
            f"at {record.opening:.2f}, {faults}; {bad} with a fault. {why}",
            markup=False,
        )
    records.sort(key=lambda item: item.seed)
    summary = OpeningSummary(options.suite, options.seed, records)
    if options.json is not None:
        options.json.write_text(json.dumps(summary.to_json(), indent=1) + "\n", "utf-8")
    _print(summary, Console())
    return 0 if all(bar.met for bar in summary.bars()) else 1


def _print(summary: OpeningSummary, console: Console) -> None:
    table = Table("", "measured", "demanded", "", title=f"{summary.suite}: {len(summary.records)} episodes")
    for bar in summary.bars():
        table.add_row(bar.name, bar.value, bar.limit, "ok" if bar.met else "MISSED")
    table.add_section()
    for name, value in summary.figures().items():
        table.add_row(name.replace("_", " "), f"{value:g}", "", "")
    console.print(table)
    for record in (item for item in summary.records if item.faults):
        line = f"seed {record.seed}: {', '.join(record.faults)}. {record.failure or record.detail or ''}"
        console.print(line[:400], markup=False)
