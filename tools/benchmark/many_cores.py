"""Evaluating on many cores: what 10,000 episodes would take, by a model that is checked on one and on two.

The model: each core is ready after a while, then runs one episode after another, each as long as one that
was measured; a worker that is used up is replaced; and the one process that hands out orders and keeps
records has so much to do for each. What it leaves out is what cores that share a memory cost each other.
"""

from __future__ import annotations

import heapq
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np

from robots.clock import WallClock
from tools.benchmark.figures import Figure, figure
from tools.evaluate.episode import run_episode
from tools.evaluate.harness.journal import Journal
from tools.evaluate.harness.ray_cluster import LOCAL, run_on_ray
from tools.evaluate.harness.worker_pool import EPISODES_A_PROCESS, Ended, run_in_processes
from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.records import EpisodeRecord

EPISODES = 10_000
CORES = (2, 10, 100, 1000, 10_000)
_FIRST_SEED = 7_700
_HOUR_S, _MINUTE_S = 3600.0, 60.0
_US = 1e6
_SEED = 1

Ends = Iterator[Ended[EpisodeOrder, EpisodeRecord]]
Backend = Callable[[Sequence[EpisodeOrder], int], Ends]


@dataclass(frozen=True, slots=True)
class Took:
    """What some episodes took.

    Attributes:
        all_s: Wall time from the first order to the last record.
        begun_s: Until a worker was at its first episode.
        episodes_s: Wall time of each episode.
        processors_s: Processor time of each.
        kept_s: Processor time of the process that hands out and keeps, for each episode.
        told_s: What Ray says that all episodes took together; 0 without it.
    """

    all_s: float
    begun_s: float
    episodes_s: tuple[float, ...]
    processors_s: tuple[float, ...]
    kept_s: float
    told_s: float = 0.0


def many_cores(quick: bool) -> list[Figure]:
    """Each backend on one core and on two, the model beside them, and the model for many."""
    count = 6 if quick else 64
    found = [_in_turns(*((3, 1) if quick else (8, 5)))]
    for name, backend in _BACKENDS.items():
        one, two = (_measured(backend, count, jobs) for jobs in (1, 2))
        for jobs, took in ((1, one), (2, two)):
            predicted_s = predicted(one, count, jobs)
            found.append(
                figure(f"{name}, {count} episodes on {jobs}, s", [took.all_s], "the model", [predicted_s])
            )
        found += _beside_another(name, count, one, two)
        a_core_hour = _HOUR_S / (float(np.mean(one.episodes_s)) + one.kept_s)
        found += [
            figure(f"{name}, episodes a core-hour", [a_core_hour]),
            figure(f"{name}, until the first episode begins, s", [one.begun_s]),
            figure(f"{name}, of the one that hands out and keeps, ms an episode", [1e3 * one.kept_s]),
        ]
        if one.told_s:
            ours_s = sum(one.episodes_s)
            found.append(
                figure(f"{name}, all episodes, s", [ours_s], "as Ray accounts for them", [one.told_s])
            )
        found += [
            figure(f"{name}, {EPISODES} on {cores} cores, min", [predicted(one, EPISODES, cores) / _MINUTE_S])
            for cores in CORES
        ]
    return found


def _beside_another(name: str, count: int, one: Took, two: Took) -> list[Figure]:
    """What the model leaves out, told apart: what an episode costs where another one runs beside it."""
    shared_s = predicted(replace(one, episodes_s=two.episodes_s), count, 2)
    return [
        figure(f"{name}, an episode beside another, s", two.episodes_s, "alone", one.episodes_s),
        figure(f"{name}, of it processor time, s", two.processors_s, "alone", one.processors_s),
        figure(f"{name}, {count} episodes on 2, s", [two.all_s], "the model, an episode as long", [shared_s]),
    ]


def predicted(took: Took, count: int, cores: int) -> float:
    """The model's wall time for so many episodes on so many cores, s.

    Args:
        took: What was measured on one core.
        count: Of episodes.
        cores: That many run at once.
    """
    lasts_s = iter(np.random.default_rng(_SEED).choice(took.episodes_s, count).tolist())
    running = [(took.begun_s + last_s, 1) for last_s in islice(lasts_s, cores)]
    heapq.heapify(running)
    kept_s = 0.0
    while running:
        ends_s, done = heapq.heappop(running)
        kept_s = max(kept_s, ends_s) + took.kept_s
        last_s = next(lasts_s, None)
        if last_s is not None:
            anew_s = took.begun_s if done % EPISODES_A_PROCESS == 0 else 0.0
            heapq.heappush(running, (kept_s + anew_s + last_s, done + 1))
    return kept_s


def _processes(orders: Sequence[EpisodeOrder], jobs: int) -> Ends:
    return run_in_processes(orders, jobs, run_episode)


def _ray(orders: Sequence[EpisodeOrder], jobs: int) -> Ends:
    return run_on_ray(orders, LOCAL, jobs, run_episode)


_BACKENDS: dict[str, Backend] = {"processes": _processes, "Ray": _ray}


def _in_turns(count: int, turns: int) -> Figure:
    """What an episode takes by Ray and in processes, one core each, their start left out: in turns."""
    took_s: dict[str, list[float]] = {name: [] for name in _BACKENDS}
    for _ in range(turns):
        for name, backend in _BACKENDS.items():
            took = _measured(backend, count, 1)
            took_s[name].append((took.all_s - took.begun_s) / count)
    return figure("an episode by Ray, s", took_s["Ray"], "in processes", took_s["processes"])


def _measured(backend: Backend, count: int, jobs: int) -> Took:
    wall, orders = WallClock(), [EpisodeOrder(_FIRST_SEED + k) for k in range(count)]
    with tempfile.TemporaryDirectory(prefix="many-cores-") as folder:
        journal = Journal[EpisodeOrder, EpisodeRecord](Path(folder) / "all.jsonl", "pick", "", run_episode)
        began_s, begun_s, before_s, all_s, kept_s, told_s = wall.now_s(), 0.0, 0.0, 0.0, 0.0, 0.0
        episodes_s: list[float] = []
        processors_s: list[float] = []
        for ended in backend(orders, jobs):
            assert ended.record is not None
            journal.add(ended.order, ended.record, ended.cost)
            if not episodes_s:  # what comes before is the start
                begun_s, before_s = wall.now_s() - began_s - ended.cost.wall_s, time.process_time()
            episodes_s.append(ended.cost.wall_s)
            processors_s.append(ended.cost.processor_s)
            all_s, kept_s = wall.now_s() - began_s, time.process_time() - before_s
            if len(episodes_s) == count and backend is _ray:
                told_s = _told_by_ray()
    mean_kept_s = kept_s / max(count - 1, 1)
    return Took(all_s, begun_s, tuple(episodes_s), tuple(processors_s), mean_kept_s, told_s)


def _told_by_ray() -> float:
    import ray

    events: list[dict[str, Any]] = ray.timeline()
    told_us: float = sum(event["dur"] for event in events if event.get("cat") == "task:execute")
    return told_us / _US
