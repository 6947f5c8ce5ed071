"""Suite ``kill``: the executive of a served robot is killed or hangs; the robot must stop, stand, go on."""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
from rich.console import Console
from rich.table import Table

from tools.evaluate.live.kill_episode import HANG_WITHIN_S, KILL_WITHIN_S, KillRecord, run_kill_episode


def run_kill(episodes: int, seed: int, robot: str, pace: float, file: Path | None, messages: Console) -> int:
    """Run the suite, one episode after the other: each has processes of its own that need the machine.

    Even episodes are killed, odd ones hang; 0 when all were as they have to be.
    """
    records: list[KillRecord] = []
    for i in range(episodes):
        record = run_kill_episode(seed + i // 2, robot, bool(i % 2), pace)
        records.append(record)
        good = sum(one.good for one in records)
        braking = "nothing moved" if record.braking_s is None else f"braking after {record.braking_s:.3f} s"
        messages.print(
            f"{i + 1} of {episodes}: seed {record.seed} {record.signal} {record.outcome}, "
            f"{record.motion or 'at rest'}, {braking}; good {good}",
            markup=False,
        )
    if file is not None:
        file.write_text(json.dumps(summary(records, seed), indent=1) + "\n", "utf-8")
    print_kill(records, Console())
    return 0 if all(record.good for record in records) else 1


def summary(records: list[KillRecord], seed: int) -> dict[str, Any]:
    """The suite's JSON document."""
    good = sum(record.good for record in records)
    failures: dict[str, int] = {}
    for record in records:
        if not record.good:
            failures[record.outcome] = failures.get(record.outcome, 0) + 1
    return {
        "suite": "kill",
        "episodes": len(records),
        "seed": seed,
        "success_rate": good / max(len(records), 1),
        "falls": sum(record.fallen for record in records),
        "failures": failures,
        "failed_seeds": [[record.seed, record.signal] for record in records if not record.good],
        "braking_s": {name: _spread(records, name) for name in ("SIGKILL", "SIGSTOP")},
        "episodes_detail": [asdict(record) for record in records],
    }


def print_kill(records: list[KillRecord], console: Console) -> None:
    """Print the table, and what went wrong."""
    table = Table("", "measured", "demanded", title=f"kill: {len(records)} episodes")
    for name, bound in (("SIGKILL", KILL_WITHIN_S), ("SIGSTOP", HANG_WITHIN_S)):
        spread = _spread(records, name)
        moving = sum(record.signal == name and bool(record.motion) for record in records)
        some = sum(record.signal == name for record in records)
        table.add_row(f"{name}: something moved", f"{moving} of {some}", "")
        table.add_row(f"{name}: braking began within", f"{spread['worst']} s at worst", f"{bound} s")
    count = len(records)
    table.add_row("fell", str(sum(record.fallen for record in records)), "0")
    table.add_row("setpoints refused", str(sum(record.refused for record in records)), "0")
    table.add_row("a new executive completed a task", f"{sum(r.resumed for r in records)} of {count}", "all")
    console.print(table)
    for record in records:
        if not record.good:
            line = f"seed {record.seed} {record.signal}: {record.outcome}. {record.detail[-800:]}"
            console.print(line, markup=False, soft_wrap=True)


def _spread(records: list[KillRecord], name: str) -> dict[str, float | None]:
    found = [r.braking_s for r in records if r.signal == name and r.motion and r.braking_s is not None]
    if not found:
        return {"p50": None, "worst": None}
    return {"p50": round(float(np.median(found)), 4), "worst": round(max(found), 4)}
