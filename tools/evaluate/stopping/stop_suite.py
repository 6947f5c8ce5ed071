"""The suites ``stop`` and ``cancel``."""

from __future__ import annotations

import argparse
from functools import partial

from rich.console import Console

from tools.evaluate.record_suite import run_record_suite
from tools.evaluate.stopping.stop_episode import died, run_stops, stop_orders
from tools.evaluate.stopping.stop_record import StopRecord, StopSummary


def run_stop_suite(options: argparse.Namespace, messages: Console) -> int:
    """Run it; 0 when every demand is met, 1 when not."""
    return run_record_suite(
        options.suite,
        stop_orders(
            options.suite,
            options.episodes,
            options.seed,
            options.robot,
            options.course,
            scene=options.scene,
        ),
        run_stops,
        died,
        partial(StopSummary, options.suite, options.seed),
        line=_line,
        place=lambda record: (record.seed, record.t_s),
        execution=options.execution,
        document=options.json,
        messages=messages,
    )


def _line(record: StopRecord) -> str:
    what = ", ".join(record.faults) or "ok"
    if record.late_joint and "still moving" in record.faults:
        what += f" ({record.late_joint} {record.late_rad_s:.3f} rad/s)"
    then = f" then {record.next_task}: {record.next_outcome}" if record.next_task else ""
    why = f" {record.next_reason}" if record.next_reason else ""
    broken = f" {record.error.strip().splitlines()[-1]}" if record.error else ""
    where = f"seed {record.seed}, {record.course}, at {record.t_s:.2f} s ({record.phase})"
    return f"{where}: {what}.{then}{why}{broken}"
