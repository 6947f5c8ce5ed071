"""Suite ``load``: picks on a served robot while other processes take every core, at the wall's pace.

However late a period is, no setpoint may be refused and nothing stopped without a reason; how late they
were is told as a histogram, once with ordinary and once with real-time scheduling where it is permitted.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.table import Table

from robots.live.wire.messages import write_message
from tools.evaluate.live.served_robot import ServedRobot

_BUSY = "while True: pass"
_FIRST_PACE = 0.05
"""A task is refused while most periods are late; what is judged here is one that is under way."""


def run_load(options: argparse.Namespace, messages: Console) -> int:
    """Run the suite: each episode a pick, even ones with ordinary scheduling; 0 without a false stop.

    ``--jobs`` is how many other processes never rest.
    """
    episodes, seed, robot, pace, others, file = (
        getattr(options, name) for name in ("episodes", "seed", "robot", "pace", "jobs", "json")
    )
    busy = [subprocess.Popen([sys.executable, "-c", _BUSY]) for _ in range(others)]
    records: list[dict[str, Any]] = []
    try:
        for i in range(episodes):
            records.append(_episode(seed + i // 2, robot, pace, bool(i % 2)))
            messages.print(f"{i + 1} of {episodes}: {_line(records[-1])}", markup=False, soft_wrap=True)
    finally:
        for process in busy:
            process.kill()
            process.wait()
    good = sum(record["good"] for record in records)
    document = {
        "suite": "load",
        "episodes": episodes,
        "seed": seed,
        "success_rate": good / episodes,
        "busy_processes": others,
        "load_average": os.getloadavg()[0],
        "falls": sum(record["fallen"] for record in records),
        "failed_seeds": [record["seed"] for record in records if not record["good"]],
        "episodes_detail": records,
    }
    if file is not None:
        file.write_text(json.dumps(document, indent=1) + "\n", "utf-8")
    for record in records:
        _print(record, Console())
    return 0 if good == episodes else 1


def _episode(seed: int, robot: str, pace: float, realtime: bool) -> dict[str, Any]:
    with tempfile.TemporaryDirectory(prefix="load-") as folder:
        served = ServedRobot(Path(folder), seed, robot, _FIRST_PACE, realtime=realtime)
        try:
            served.wait_until_ready()
            served.send()
            served.wait(lambda: served.started > 0 or bool(served.results()), "the first motion begins")
            served.evaluate(write_message("pace", pace=pace))
            served.wait(lambda: bool(served.results()), "the task ends")
            (result,) = served.results()
            status = served.status()
            fallen = served.fallen()
        finally:
            served.end()
    stops = list(status["stops"])
    return {
        "seed": seed,
        "scheduling": status["scheduling"],
        "exit_code": result["exit_code"],
        "outcome": result["text"],
        "stops": stops,
        "refused": status["setpoints"]["refused"],
        "fallen": fallen,
        "t_s": status["t_s"],
        "lateness": status["lateness"],
        "good": not stops and not status["setpoints"]["refused"] and not fallen,
    }


def _line(record: dict[str, Any]) -> str:
    late = record["lateness"]
    return (
        f"seed {record['seed']}, {record['scheduling']}: {record['outcome'][:200]}; "
        f"late p50 {late['p50_ms']:.2f}, p99 {late['p99_ms']:.2f}, worst {late['worst_ms']:.0f} ms, "
        f"lost {late['lost_s']:.1f} s, held {late['held_s']:.1f} s; stops {record['stops']}"
    )


def _print(record: dict[str, Any], console: Console) -> None:
    table = Table(
        "late up to, ms", "periods", "share", title=f"seed {record['seed']}: {record['scheduling']}"
    )
    periods = record["lateness"]["periods"]
    for upper_ms, count in record["lateness"]["histogram"]:
        table.add_row(f"{upper_ms:.3g}", str(count), f"{count / periods:.4f}")
    console.print(table)
