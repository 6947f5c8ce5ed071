"""Episodes run beside each other, and one that dies takes no other with it."""

import os

import pytest

from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.phases import PhaseWatch
from tools.evaluate.records import EpisodeRecord
from tools.evaluate.workers import run_all
from trees.events import NodeChanged


def fine(order):
    return EpisodeRecord(order.seed, "done", True, detail=os.environ["OMP_NUM_THREADS"])


def dies_at_two(order):
    if order.seed == 2:
        os._exit(1)
    return fine(order)


@pytest.mark.parametrize("jobs", [1, 2])
def test_every_episode_gives_one_record_on_one_core(jobs):
    found = list(run_all([EpisodeOrder(seed) for seed in range(4)], jobs, fine))

    assert sorted(record.seed for record in found) == [0, 1, 2, 3]
    assert {record.detail for record in found} == {"1"}


def test_a_process_that_dies_costs_its_own_episode_and_the_rest_goes_on():
    found = {r.seed: r for r in run_all([EpisodeOrder(seed) for seed in range(6)], 1, dies_at_two)}

    assert set(found) == set(range(6))
    assert [seed for seed, record in found.items() if record.outcome == "error"] == [2]


def test_a_phase_is_remembered_by_its_first_beginning():
    watch = PhaseWatch()
    for t_s, where, status in (
        (1.0, "pick/attempt/stream reach", "running"),
        (2.0, "pick/attempt/stream reach", "success"),
        (5.0, "pick/attempt/stream reach", "running"),
    ):
        watch.take(NodeChanged(t_s, where, status, ""))

    assert watch.began_s("stream reach") == 1.0
    assert watch.began_s("stream lift") is None
