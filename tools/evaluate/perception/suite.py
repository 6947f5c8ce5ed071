"""Suite ``perception``: pictures of random tables, looked at and judged, a scene each."""

from __future__ import annotations

import argparse
import json
import pickle
from dataclasses import dataclass

from rich.console import Console
from rich.table import Table

from robots.scenes.light import LightKind
from tools.evaluate.harness.execution import run_each
from tools.evaluate.perception.drawing import draw_calibration, draw_worst
from tools.evaluate.perception.judge import Bench, PictureRecord
from tools.evaluate.perception.summary import PerceptionSummary
from tools.evaluate.perception.two_cameras import run_two_cameras

PERCEPTION_SUITE = "perception"
_A_RUN = 10
"""Pictures by one process before the next is asked: an OpenGL context is made for each."""


@dataclass(frozen=True, slots=True)
class PictureOrder:
    """Some pictures to judge: their seeds, and another light than theirs."""

    seeds: tuple[int, ...]
    light: LightKind | None = None


def run_perception(options: argparse.Namespace, messages: Console) -> int:
    """Judge pictures; 0 when every demand is met, 1 when not."""
    if options.cameras == 2:
        return run_two_cameras(options, messages)
    seeds = range(options.seed, options.seed + options.episodes)
    orders = [PictureOrder(tuple(seeds[i : i + _A_RUN]), options.light) for i in range(0, len(seeds), _A_RUN)]
    records: list[PictureRecord] = []
    for some in run_each(orders, options.execution, judge_pictures, _died):
        records += some
        messages.print(f"{len(records)} of {len(seeds)} pictures")
        if options.pictures is not None:
            options.pictures.write_bytes(pickle.dumps(records))
    summary = PerceptionSummary(sorted(records, key=lambda record: record.seed))
    if options.json is not None:
        options.json.write_text(json.dumps(summary.to_json(), indent=1) + "\n", "utf-8")
        draw_calibration(summary, options.json.with_suffix(".calibration.png"))
        draw_worst(summary.worst(), options.json.with_suffix(".worst.png"), options.light)
    table = Table("", "measured", "demanded", "", title=f"perception: {len(records)} pictures")
    for bar in summary.bars():
        table.add_row(bar.name, bar.value, bar.limit, "ok" if bar.met else "MISSED")
    table.add_section()
    for name, value in summary.figures().items():
        table.add_row(name, f"{value:g}", "", "")
    console = Console()
    console.print(table)
    for true, told, count in summary.confusions():
        console.print(f"{count} {true} things were called {told}")
    for record in summary.records:
        if record.broken:
            console.print(f"seed {record.seed}: {record.broken}", markup=False)
    return 0 if all(bar.met for bar in summary.bars()) else 1


def judge_pictures(order: PictureOrder) -> list[PictureRecord]:
    """The records of some pictures; what breaks becomes its record."""
    bench = Bench()
    records = []
    for seed in order.seeds:
        try:
            records.append(bench.judge(seed, order.light))
        except Exception as broken:
            records.append(_broken(seed, repr(broken)))
    return records


def _died(order: PictureOrder) -> list[PictureRecord]:
    return [_broken(seed, "the process died") for seed in order.seeds]


def _broken(seed: int, why: str) -> PictureRecord:
    return PictureRecord(seed, "", "", 0.0, (), broken=why)
