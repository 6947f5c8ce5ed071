"""The suites ``stop`` and ``cancel``."""

from __future__ import annotations

import argparse
import json

from rich.console import Console
from rich.table import Table

from tools.evaluate.stopping.stop_episode import died, run_stops, stop_orders
from tools.evaluate.stopping.stop_record import StopRecord, StopSummary
from tools.evaluate.workers import run_each

_SHOWN = 25


def run_stop_suite(options: argparse.Namespace, messages: Console) -> int:
    """Run it; 0 when every demand is met, 1 when not."""
    orders = stop_orders(options.suite, options.episodes, options.seed, options.robot)
    records: list[StopRecord] = []
    for found in run_each(orders, options.jobs, run_stops, died):
        records.extend(found)
        bad = sum(bool(record.faults) for record in records)
        for record in found:
            if record.faults:
                messages.print(_line(record), markup=False)
        messages.print(f"{len(records)} of {options.episodes} instants, {bad} with a fault")
    records.sort(key=lambda record: (record.seed, record.t_s))
    summary = StopSummary(options.suite, options.seed, records)
    if options.json is not None:
        options.json.write_text(json.dumps(summary.to_json(), indent=1) + "\n", "utf-8")
    _print(summary, Console())
    return 0 if all(bar.met for bar in summary.bars()) else 1


def _print(summary: StopSummary, console: Console) -> None:
    table = Table("", "measured", "demanded", "", title=f"{summary.suite}: {len(summary.records)} instants")
    for bar in summary.bars():
        table.add_row(bar.name, bar.value, bar.limit, "ok" if bar.met else "MISSED")
    table.add_section()
    for name, value in summary.figures().items():
        table.add_row(name.replace("_", " "), f"{value:g}", "", "")
    for phase, count in summary.to_json()["phases"].items():
        table.add_row(f"phase {phase}", str(count), "", "")
    console.print(table)
    bad = [record for record in summary.records if record.faults]
    for record in bad[:_SHOWN]:
        console.print(_line(record), markup=False)
        if record.error:
            console.print(record.error.strip().splitlines()[-1], markup=False)
    if len(bad) > _SHOWN:
        console.print(f"and {len(bad) - _SHOWN} more, all in the JSON")


def _line(record: StopRecord) -> str:
    what = ", ".join(record.faults)
    more = f"{record.next_task}: {record.next_reason}" if record.next_reason else ""
    if record.late_joint and "still moving" in record.faults:
        what += f" ({record.late_joint} {record.late_rad_s:.3f} rad/s)"
    return f"seed {record.seed} at {record.t_s:.2f} s ({record.phase}): {what}. {more}".strip()
