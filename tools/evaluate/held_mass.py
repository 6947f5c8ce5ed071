"""Episodes of picks of all weights: how near what the robot weighs in its hand is to the truth.

An episode is one of the suite "pick" whose cup weighs something else: 0.1 to 1.5 kg, drawn by the seed.
"""

from __future__ import annotations

import argparse
import json
from dataclasses import replace

import numpy as np
from rich.console import Console

from executive.runs.run import frozen_heap
from executive.session.assembly import assemble
from executive.session.task_result import chain
from executive.understanding.command_parser import parse
from tools.evaluate.harness.execution import run_each
from tools.evaluate.judge import HELD_S, Judge
from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.records import EpisodeRecord, broken_episode, dead_episode
from tools.evaluate.scenes import TARGET, episode_rng, episode_scene, read_episode_scene, sentence_for

HELD_MASS_SUITE = "held_mass"
MASS_KG = (0.1, 1.5)
ERROR_BAR = 0.15
"""The estimate two seconds after the lift is nearer than this share of the truth."""


def run_held_mass_episode(order: EpisodeOrder) -> EpisodeRecord:
    """Run one episode; whatever breaks becomes its record."""
    try:
        return _run(order)
    except Exception as broken:
        return broken_episode(order, broken)


def _run(order: EpisodeOrder) -> EpisodeRecord:
    scene = read_episode_scene(episode_scene(order.seed, None, order.scene), order.seed)
    true_kg = float(episode_rng(order.seed, 9).uniform(*MASS_KG))
    things = tuple(replace(item, mass_kg=true_kg) if item.name == TARGET else item for item in scene.objects)
    scene = replace(scene, objects=things)
    assembly = assemble(order.robot, scene, order.seed, drawn=False)
    session = assembly.session
    judge = Judge(assembly.world.truth, TARGET)
    session.watch_periods(judge.on_period)
    (command,) = parse(sentence_for(scene)).commands
    with frozen_heap():
        result = session.run_task(command)
        judge.begin_hold()
        session.hold(HELD_S)
    links = chain(result.failure)
    numbers: dict[str, float | int | str | bool] = {"true_mass_kg": true_kg}
    found = result.evidence.get("mass_kg")
    if isinstance(found, float):
        numbers |= {"mass_kg": found, "mass_error": abs(found / true_kg - 1.0)}
    return EpisodeRecord(
        seed=order.seed,
        outcome=result.outcome,
        truth=judge.truly_held,
        failure_kind=links[-1].kind.value if links else None,
        failure=" ← ".join(link.message for link in links) or None,
        attempts=result.attempts,
        slip_m=judge.slip_m,
        fell=judge.fell,
        simulated_s=result.times.simulated_s,
        wall_s=result.times.wall_s,
        numbers=numbers,
    )


def run_held_mass(options: argparse.Namespace, messages: Console) -> int:
    """Run the suite; 0 when every held cup was weighed nearly enough, and one was held at all."""
    orders = [EpisodeOrder(options.seed + i, options.robot) for i in range(options.episodes)]
    records = []
    for record in run_each(orders, options.execution, run_held_mass_episode, dead_episode):
        records.append(record)
        messages.print(f"seed {record.seed} {record.outcome} {dict(record.numbers)}", markup=False)
    records.sort(key=lambda record: record.seed)
    errors = np.array([float(record.numbers["mass_error"]) for record in records if _weighed(record)])
    document = {
        "suite": HELD_MASS_SUITE,
        "seed": options.seed,
        "episodes": len(records),
        "done": sum(record.claimed for record in records),
        "weighed": len(errors),
        "beyond_bar": int((errors > ERROR_BAR).sum()),
        "error": {"p50": float(np.median(errors)), "max": float(errors.max())} if len(errors) else None,
    }
    if options.json is not None:
        episodes = [record.to_json() for record in records]
        options.json.write_text(json.dumps({**document, "records": episodes}, indent=1) + "\n", "utf-8")
    Console().print_json(json.dumps(document))
    return 0 if len(errors) and not document["beyond_bar"] else 1


def _weighed(record: EpisodeRecord) -> bool:
    return record.claimed and "mass_error" in record.numbers
