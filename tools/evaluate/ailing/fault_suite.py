"""The suite ``fault``."""

from __future__ import annotations

import argparse
import json

from rich.console import Console
from rich.table import Table

from tools.evaluate.ailing.fault_episode import FaultOrder, died, run_fault
from tools.evaluate.ailing.fault_record import FaultRecord, FaultSummary
from tools.evaluate.workers import run_each


def run_fault_suite(options: argparse.Namespace, messages: Console) -> int:
    """Run it; 0 when every demand is met, 1 when not."""
    orders = [FaultOrder(options.seed + i, options.fault, options.robot) for i in range(options.episodes)]
    records: list[FaultRecord] = []
    for record in run_each(orders, options.jobs, run_fault, died):
        records.append(record)
        messages.print(f"{len(records)} of {len(orders)}: {_line(record)}", markup=False, soft_wrap=True)
    records.sort(key=lambda record: record.seed)
    summary = FaultSummary(options.fault, options.seed, records)
    if options.json is not None:
        options.json.write_text(json.dumps(summary.to_json(), indent=1) + "\n", "utf-8")
    _print(summary, Console())
    return 0 if all(bar.met for bar in summary.bars()) else 1


def _print(summary: FaultSummary, console: Console) -> None:
    title = f"fault {summary.fault}: {len(summary.records)} episodes"
    table = Table("", "measured", "demanded", "", title=title)
    for bar in summary.bars():
        table.add_row(bar.name, bar.value, bar.limit, "ok" if bar.met else "MISSED")
    table.add_section()
    for name, value in summary.figures().items():
        table.add_row(name, f"{value:g}", "", "")
    console.print(table)
    for record in summary.records:
        if record.faults or record.fell:
            console.print(_line(record), markup=False, soft_wrap=True)


def _line(record: FaultRecord) -> str:
    if record.error is not None:
        return f"seed {record.seed}: {record.error.strip().splitlines()[-1]}"
    noticed = (
        f"{record.ailment} of {record.blamed} after {record.noticed_s:.2f} s"
        if record.noticed_s is not None
        else "not noticed"
    )
    broken = ", ".join(record.faults) or "ok"
    fell = (
        "" if not record.fell else f", fell ({'also' if record.fells_standing else 'not'} when only standing)"
    )
    where = f"{record.part} at {record.t_s:.1f} s ({record.phase})".strip()
    return f"seed {record.seed}: {broken}; {where}: {noticed}, {record.outcome}, {record.state}{fell}"
