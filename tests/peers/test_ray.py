"""Episodes on a Ray cluster of this machine: the same records, whatever dies, and nobody else hears of it."""

import importlib.util
import os
import signal
import subprocess
import time
from pathlib import Path

import pytest

from tools.evaluate.harness.execution import Execution, run_each
from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.records import EpisodeRecord, dead_episode

pytestmark = [
    pytest.mark.requirement("U7"),
    pytest.mark.timeout(300),
    # not by importing it: where it listens is settled by the settings that it finds then
    pytest.mark.skipif(importlib.util.find_spec("ray") is None, reason="ray is not installed"),
]
ORDERS = [EpisodeOrder(seed) for seed in range(12)]


def fine(order: EpisodeOrder) -> EpisodeRecord:
    time.sleep(0.1)
    return EpisodeRecord(order.seed, "done", order.seed % 3 > 0)


def dies_once(order: EpisodeOrder) -> EpisodeRecord:
    been = Path(os.environ["BEEN_THERE"]) / str(order.seed)
    if order.seed % 4 == 0 and not been.exists():
        been.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return fine(order)


def listening():
    """Addresses on which Ray's own programs listen."""
    told = subprocess.run(["ss", "-ltnpH"], capture_output=True, text=True, check=True).stdout
    return {line.split()[3] for line in told.splitlines() if "raylet" in line or "gcs_server" in line}


@pytest.mark.requirement("U7")
def test_every_episode_is_recorded_once_and_as_by_processes_though_workers_die(tmp_path, monkeypatch):
    monkeypatch.setenv("BEEN_THERE", str(tmp_path))
    kept = tmp_path / "kept.jsonl"
    found = list(run_each(ORDERS, Execution("x", 2, kept, "local"), dies_once, dead_episode))

    def by_seed(records):
        return sorted(records, key=lambda record: record.seed)

    assert by_seed(found) == by_seed(run_each(ORDERS, Execution("x", 2), fine, dead_episode))
    assert len(kept.read_text().splitlines()) == len(ORDERS)


def test_a_cluster_of_this_machine_listens_on_loopback_alone():
    heard = set()
    for _ in run_each(ORDERS[:4], Execution("x", 1, None, "local"), fine, dead_episode):
        heard |= listening()

    assert heard
    assert all("127.0.0.1" in address for address in heard)
