"""Episodes on a Ray cluster: one of this machine alone, or one that runs already.

Nothing is told to anybody: usage statistics and the dashboard are off, and a cluster of this machine listens
on loopback alone. A cluster that runs already gets the sources and the compiled code of this machine with the
first order; what the product needs from the registry has to be installed there.
"""

from __future__ import annotations

import importlib.util
import os
import sys
from collections import deque
from collections.abc import Callable, Hashable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from executive.errors import UserError
from tools.evaluate.harness.shipped_kernel import NOTHING, packed_kernel, unpack_kernel
from tools.evaluate.harness.worker_pool import (
    DEATHS,
    EPISODES_A_PROCESS,
    Cost,
    Ended,
    one_thread_each,
    run_tidily,
)

LOCAL = "local"
_ROOT = Path(__file__).parents[3]
_PACKAGES = ("kinematics", "robots", "trees", "executive", "tools")
_STORE_BYTES = 100_000_000
"""Records are small: what Ray would take for its object store is the simulators'."""
_QUIET = {"RAY_USAGE_STATS_ENABLED": "0", "RAY_DEDUP_LOGS": "0", "RAY_ACCEL_ENV_VAR_OVERRIDE_ON_ZERO": "0"}
_FRUGAL = {"MALLOC_ARENA_MAX": "1"}
"""A worker has some ten threads of Ray's, each of which would keep memory of its own."""
_LOOPBACK = {"RAY_ENABLE_WINDOWS_OR_OSX_CLUSTER": "0"}
"""Without it Ray takes 127.0.0.1 for a wish to be reached from elsewhere, and listens to every network."""
_NO_RAY = "--ray needs the extra [cluster]: pip install 'humanoid-executive[cluster]'"

Order = TypeVar("Order", bound=Hashable)
Record = TypeVar("Record")


def run_on_ray(
    orders: Sequence[Order], address: str, jobs: int, run: Callable[[Order], Record]
) -> Iterator[Ended[Order, Record]]:
    """Yield the orders as they are through, in no promised order.

    Args:
        orders: What to run.
        address: "local", or the address of a cluster's head ("HOST:PORT", "auto").
        jobs: Number of cores of a local cluster; another one says itself what it has.
        run: What runs one order; importable by name. What it raises ends everything.

    Raises:
        UserError: Ray is not installed, or nobody answers at the address.
    """
    if importlib.util.find_spec("ray") is None:
        raise UserError(_NO_RAY)
    os.environ.update({**_QUIET, **(_LOOPBACK if address == LOCAL else {})})
    import ray
    from ray.exceptions import NodeDiedError, OutOfMemoryError, RayTaskError, WorkerCrashedError

    lost = (WorkerCrashedError, NodeDiedError, OutOfMemoryError)
    _join(ray, address, jobs)
    try:
        remote = ray.remote(num_cpus=1, max_calls=EPISODES_A_PROCESS, max_retries=0)(_run)
        compiled = ray.put(packed_kernel() if address != LOCAL else NOTHING)
        waiting, deaths = deque(orders), dict.fromkeys(orders, 0)
        running: dict[Any, Order] = {}
        while waiting or running:
            # two for each core: the next one is there when an episode ends, and nodes may come and go
            room = 2 * max(1, int(ray.cluster_resources().get("CPU", 1.0)))
            while waiting and len(running) < room:
                order = waiting.popleft()
                running[remote.remote(run, order, compiled)] = order
            (found,), _ = ray.wait(list(running), num_returns=1)
            order = running.pop(found)
            try:
                record, cost = ray.get(found)
            except lost as death:
                deaths[order] += 1
                if deaths[order] < DEATHS:
                    waiting.append(order)
                else:
                    yield Ended(order, None, Cost(process=type(death).__name__, deaths=deaths[order]))
            except RayTaskError as broken:
                raise broken.as_instanceof_cause() from None
            else:
                yield Ended(order, record, replace(cost, deaths=deaths[order]))
    finally:
        ray.shutdown()


def _run(run: Callable[[Order], Record], order: Order, compiled: NDArray[np.uint8]) -> tuple[Record, Cost]:
    unpack_kernel(compiled)
    return run_tidily(run, order)


def _join(ray: Any, address: str, jobs: int) -> None:
    settings = {**one_thread_each(), **_QUIET, **_FRUGAL}
    if address == LOCAL:
        here = os.pathsep.join(filter(None, sys.path))
        ray.init(
            num_cpus=jobs,
            include_dashboard=False,
            log_to_driver=False,
            object_store_memory=_STORE_BYTES,
            _node_ip_address="127.0.0.1",
            runtime_env={"env_vars": {**settings, "PYTHONPATH": here}},
        )
        return
    shipped = {"env_vars": settings, "py_modules": [str(_ROOT / name) for name in _PACKAGES]}
    try:
        ray.init(address=address, log_to_driver=False, runtime_env=shipped)
    except (ConnectionError, ValueError, RuntimeError) as wrong:
        first = str(wrong).splitlines()[0]
        raise UserError(f"no Ray cluster answers at {address!r}: {first}") from None
