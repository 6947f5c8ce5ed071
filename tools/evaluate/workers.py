"""Run episodes in processes of their own, one core each; a process that dies costs its episode only."""

from __future__ import annotations

import gc
import multiprocessing
import os
from collections.abc import Callable, Hashable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from typing import TypeVar

from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.records import EpisodeRecord

# Libraries that would spread over all cores read these when they are loaded.
_THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")

# Simulators that are thrown away leave some memory behind: a process grows by 6 MB an episode.
_EPISODES_A_PROCESS = 40

Run = Callable[[EpisodeOrder], EpisodeRecord]
Order = TypeVar("Order", bound=Hashable)
Record = TypeVar("Record")


def run_all(orders: Sequence[EpisodeOrder], jobs: int, run: Run) -> Iterator[EpisodeRecord]:
    """Yield the records as episodes end, in no promised order; see ``run_each``."""
    return run_each(orders, jobs, run, _died)


def run_each(
    orders: Sequence[Order],
    jobs: int,
    run: Callable[[Order], Record],
    died: Callable[[Order], Record],
) -> Iterator[Record]:
    """Yield a record for each order as they end, in no promised order.

    Args:
        orders: What to run.
        jobs: Number of processes; 1 still runs beside this process, so that numbers compare.
        run: What runs one order; importable by name.
        died: The record of an order whose process died.
    """
    os.environ.update(dict.fromkeys(_THREADS, "1"))
    left = list(orders)
    while left:
        done = set()
        for order, record in _run_until_broken(left, jobs, run, died):
            done.add(order)
            yield record
        left = [order for order in left if order not in done]


def _run_until_broken(
    orders: Sequence[Order],
    jobs: int,
    run: Callable[[Order], Record],
    died: Callable[[Order], Record],
) -> Iterator[tuple[Order, Record]]:
    """Run in one pool; when a process dies, blame the episodes that were under way and end."""
    context = multiprocessing.get_context("spawn")
    waiting = list(orders)
    with ProcessPoolExecutor(jobs, mp_context=context, max_tasks_per_child=_EPISODES_A_PROCESS) as pool:
        running: dict[Future[Record], Order] = {}
        while waiting or running:
            # only as many as there are processes: what is submitted is under way
            while waiting and len(running) < jobs:
                order = waiting.pop(0)
                running[pool.submit(_run_tidily, run, order)] = order
            finished, _ = wait(running, return_when=FIRST_COMPLETED)
            broken = False
            for future in finished:
                order = running.pop(future)
                try:
                    yield order, future.result()
                except BrokenProcessPool:
                    broken = True
                    yield order, died(order)
            if broken:
                return


def _died(order: EpisodeOrder) -> EpisodeRecord:
    return EpisodeRecord(
        seed=order.seed,
        outcome="error",
        truth=False,
        failure_kind="ERROR",
        failure="the process that ran this episode, or one beside it, died",
        fault=order.fault,
    )


def _run_tidily(run: Callable[[Order], Record], order: Order) -> Record:
    """Give back what the order before has left: a world that nobody holds is in no hurry to go by itself."""
    gc.collect()
    return run(order)
