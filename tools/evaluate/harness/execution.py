"""How a suite's episodes are run: where, and in which file their records are kept."""

from __future__ import annotations

import importlib.metadata
from collections.abc import Callable, Hashable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

from tools.evaluate.harness.journal import Journal
from tools.evaluate.harness.ray_cluster import run_on_ray
from tools.evaluate.harness.worker_pool import Ended, run_in_processes

Order = TypeVar("Order", bound=Hashable)
Record = TypeVar("Record")


@dataclass(frozen=True, slots=True)
class Execution:
    """Where episodes are run, and what is kept of them.

    Attributes:
        suite: Name of the suite, for the file.
        jobs: Number of processes on this machine, unless a cluster says itself.
        journal: The file that takes each record as it comes, or None: what it holds already is not run again.
        ray: Address of a Ray cluster, "local" for one of this machine alone, or None for processes.
    """

    suite: str
    jobs: int = 1
    journal: Path | None = None
    ray: str | None = None


def run_each(
    orders: Sequence[Order],
    execution: Execution,
    run: Callable[[Order], Record],
    died: Callable[[Order], Record],
) -> Iterator[Record]:
    """Yield a record for each order as they end, in no promised order.

    Args:
        orders: What to run, each once.
        execution: Where, and what is kept.
        run: What runs one order; importable by name, its return type annotated.
        died: The record of an order of which one process after another died.

    Raises:
        UserError: The journal is of something else, or the cluster cannot be reached.
    """
    journal = _journal(execution, run)
    left = dict.fromkeys(orders)
    for order, record in journal.past(orders) if journal else ():
        del left[order]
        yield record
    for ended in _begun(list(left), execution, run):
        record = died(ended.order) if ended.record is None else ended.record
        if journal:
            journal.add(ended.order, record, ended.cost)
        yield record


def _begun(
    orders: Sequence[Order], execution: Execution, run: Callable[[Order], Record]
) -> Iterator[Ended[Order, Record]]:
    if execution.ray is not None:
        return run_on_ray(orders, execution.ray, execution.jobs, run)
    return run_in_processes(orders, execution.jobs, run)


def _journal(execution: Execution, run: Callable[[Order], Record]) -> Journal[Order, Record] | None:
    if execution.journal is None:
        return None
    version = importlib.metadata.version("humanoid-executive")
    return Journal(execution.journal, execution.suite, version, run)
