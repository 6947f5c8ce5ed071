"""Episodes in processes of their own; a process that dies costs nobody but itself.

A pool of the standard library breaks as a whole when one of its processes dies, and cannot say which episode
it was. Here each process has a pipe of its own.
"""

from __future__ import annotations

import contextlib
import multiprocessing
import os
import resource
import signal
import time
from collections import deque
from collections.abc import Callable, Hashable, Iterator, Sequence
from dataclasses import dataclass, replace
from multiprocessing.connection import Connection, wait
from typing import Generic, TypeVar

from robots.clock import WallClock
from robots.simulated.frugal_memory import be_frugal, make_room

DEATHS = 5
"""An order is tried again when its process dies, and given up when so many have died of it."""
EPISODES_A_PROCESS = 40
"""Simulators that are thrown away leave some memory behind: after so many, a new process begins."""
_KB_A_MB = 1024.0
_ENDS_WITHIN_S = 5.0

# Libraries that would spread over all cores read these when they are loaded.
_THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")

Order = TypeVar("Order", bound=Hashable)
Record = TypeVar("Record")


@dataclass(frozen=True, slots=True)
class Cost:
    """What an episode took.

    Attributes:
        wall_s, processor_s: Time of the process that ran it.
        memory_mb: The most memory that this process has had resident up to then.
        process: Who ran it, as "host:pid".
        deaths: How many processes died before of the same order.
    """

    wall_s: float = 0.0
    processor_s: float = 0.0
    memory_mb: float = 0.0
    process: str = ""
    deaths: int = 0


@dataclass(frozen=True, slots=True)
class Ended(Generic[Order, Record]):
    """An order that is through: its record, None where every process died of it, and its cost."""

    order: Order
    record: Record | None
    cost: Cost


def run_tidily(run: Callable[[Order], Record], order: Order) -> tuple[Record, Cost]:
    """Run one order here, and say what it took."""
    be_frugal()
    make_room()
    clock, began_processor_s = WallClock(), time.process_time()
    record = run(order)
    memory_mb = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / _KB_A_MB
    spent = clock.now_s(), time.process_time() - began_processor_s
    return record, Cost(*spent, memory_mb, f"{os.uname().nodename}:{os.getpid()}")


def one_thread_each() -> dict[str, str]:
    """The settings of the environment that keep an episode to one core."""
    return dict.fromkeys(_THREADS, "1")


class _Worker(Generic[Order, Record]):
    """One process, and what it is at."""

    def __init__(self, run: Callable[[Order], Record]) -> None:
        context = multiprocessing.get_context("spawn")
        self.pipe, there = context.Pipe()
        self._process = context.Process(target=_serve, args=(there, run))
        self._process.start()
        there.close()
        self.name = f"{os.uname().nodename}:{self._process.pid}"
        self._order: Order | None = None
        self._done = 0

    @property
    def order(self) -> Order:
        """What it was given last."""
        assert self._order is not None
        return self._order

    @property
    def is_used_up(self) -> bool:
        """Whether another process has to go on in its place."""
        return self._done >= EPISODES_A_PROCESS

    def give(self, order: Order) -> None:
        """Let it run an order; whether it has died meanwhile is heard with the answer."""
        self._order = order
        with contextlib.suppress(OSError):
            self.pipe.send(order)

    def answer(self) -> tuple[Record, Cost] | None:
        """The record of its order, or None when it has died; what the order raised is raised here."""
        try:
            answer = self.pipe.recv()
        except (EOFError, OSError):
            return None
        if isinstance(answer, BaseException):
            raise answer
        self._done += 1
        record, cost = answer
        return record, cost

    def end(self) -> None:
        """End the process, whatever it is at."""
        self.pipe.close()
        self._process.terminate()
        self._process.join(_ENDS_WITHIN_S)
        if self._process.is_alive():
            self._process.kill()
            self._process.join()


def run_in_processes(
    orders: Sequence[Order], jobs: int, run: Callable[[Order], Record]
) -> Iterator[Ended[Order, Record]]:
    """Yield the orders as they are through, in no promised order.

    Args:
        orders: What to run.
        jobs: Number of processes; 1 still runs beside this process, so that numbers compare.
        run: What runs one order; importable by name. What it raises ends everything.
    """
    os.environ.update(one_thread_each())
    waiting, deaths = deque(orders), dict.fromkeys(orders, 0)
    idle: list[_Worker[Order, Record]] = []
    busy: dict[Connection, _Worker[Order, Record]] = {}
    try:
        while waiting or busy:
            while waiting and len(busy) < jobs:
                worker = idle.pop() if idle else _Worker(run)
                worker.give(waiting.popleft())
                busy[worker.pipe] = worker
            for pipe in wait(list(busy)):
                assert isinstance(pipe, Connection)
                worker = busy[pipe]
                answer = worker.answer()
                del busy[pipe]
                order = worker.order
                if answer is not None and not worker.is_used_up:
                    idle.append(worker)
                else:
                    worker.end()
                if answer is not None:
                    record, cost = answer
                    yield Ended(order, record, replace(cost, deaths=deaths[order]))
                    continue
                deaths[order] += 1
                if deaths[order] < DEATHS:
                    waiting.append(order)
                else:
                    yield Ended(order, None, Cost(process=worker.name, deaths=deaths[order]))
    finally:
        for worker in (*idle, *busy.values()):
            worker.end()


def _serve(pipe: Connection, run: Callable[[Order], Record]) -> None:
    """Run what comes through the pipe until it is closed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # whoever began this process ends it
    while True:
        try:
            order = pipe.recv()
        except (EOFError, OSError):
            return
        try:
            answer: object = run_tidily(run, order)
        except BaseException as broken:
            answer = broken
        try:
            pipe.send(answer)
        except OSError:
            return
