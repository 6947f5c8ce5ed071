"""The suite ``fault``."""

from __future__ import annotations

import argparse
from functools import partial

from rich.console import Console

from tools.evaluate.ailing.fault_episode import FaultOrder, died, run_faults
from tools.evaluate.ailing.fault_record import FaultRecord, FaultSummary
from tools.evaluate.record_suite import run_record_suite


def run_fault_suite(options: argparse.Namespace, messages: Console) -> int:
    """Run it; 0 when every demand is met, 1 when not."""
    return run_record_suite(
        f"fault {options.fault}",
        [FaultOrder(options.seed + i, options.fault, options.robot) for i in range(options.episodes)],
        run_faults,
        died,
        partial(FaultSummary, options.fault, options.seed),
        line=_line,
        place=lambda record: (record.seed,),
        execution=options.execution,
        document=options.json,
        messages=messages,
    )


def _line(record: FaultRecord) -> str:
    if record.error is not None:
        return f"seed {record.seed}: {record.error.strip().splitlines()[-1]}"
    noticed = (
        f"{record.ailment} of {record.blamed} after {record.noticed_s:.2f} s"
        if record.noticed_s is not None
        else f"not noticed ({record.asked_share:.0%} of its effort, {1e3 * record.off_rad:.1f} mrad off)"
    )
    broken = ", ".join(record.faults) or "ok"
    fell = (
        ""
        if not record.fell
        else f", fell ({'also' if record.fells_standing else 'not'} when standing still)"
    )
    where = f"{record.part} at {record.t_s:.1f} s ({record.phase})".strip()
    return f"seed {record.seed}: {broken}; {where}: {noticed}, {record.outcome}, {record.state}{fell}"
