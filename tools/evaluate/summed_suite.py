"""Suites whose episodes need a seed and a robot alone, and whose summaries have demands of their own."""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable, Mapping
from types import MappingProxyType

from rich.console import Console

from robots.models.description import load_description
from tools.evaluate.disturbed.pushes import PushSummary, run_push_episode
from tools.evaluate.disturbed.rough import RoughSummary, run_rough_episode
from tools.evaluate.harness.execution import run_each
from tools.evaluate.jogging.pick import JogPickSummary, run_jog_pick_episode
from tools.evaluate.jogging.random_keys import JogSummary, run_jog_episode
from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.records import EpisodeRecord, Run, Summary, dead_episode
from tools.evaluate.report import print_summary

_Suites = Mapping[str, tuple[Run, Callable[..., Summary]]]

DISTURBED_SUITES: _Suites = MappingProxyType(
    {"push": (run_push_episode, PushSummary), "rough": (run_rough_episode, RoughSummary)}
)
"""Something disturbs a bare walk: what runs an episode, and what sums up."""

JOG_SUITES: _Suites = MappingProxyType(
    {"jog": (run_jog_episode, JogSummary), "jog_pick": (run_jog_pick_episode, JogPickSummary)}
)
"""A scripted person jogs the robot."""


def run_summed_suite(options: argparse.Namespace, messages: Console) -> int:
    """Run one of them; 0 when every demand is met, 1 when not, 2 for a wrong option."""
    if options.fault or options.scene:
        messages.print(f"error: the suite {options.suite} takes no fault and no scene", style="bold")
        return 2
    run, make = {**DISTURBED_SUITES, **JOG_SUITES}[options.suite]
    orders = [EpisodeOrder(options.seed + i, options.robot) for i in range(options.episodes)]
    records: list[EpisodeRecord] = []
    for record in run_each(orders, options.execution, run, dead_episode):
        records.append(record)
        good = sum(item.truth for item in records)
        said = f"{len(records)} of {len(orders)}: seed {record.seed} {record.outcome}, good {good}"
        messages.print(said + (f"; {record.failure}" if record.failure else ""), markup=False)
    records.sort(key=lambda record: record.seed)
    margin_m = load_description(options.robot).com_margin_m
    summary = make(options.suite, options.seed, None, margin_m, records)
    if options.json is not None:
        options.json.write_text(json.dumps(summary.to_json(), indent=1) + "\n", "utf-8")
    print_summary(summary, {}, Console())
    return 0 if all(bar.met for bar in summary.bars()) else 1
