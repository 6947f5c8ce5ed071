"""The model of an evaluation on many cores."""

import pytest

from tools.benchmark.many_cores import Took, predicted
from tools.evaluate.harness.worker_pool import EPISODES_A_PROCESS

ALIKE = Took(all_s=0.0, begun_s=5.0, episodes_s=(2.0,), processors_s=(2.0,), kept_s=0.01)


def test_one_core_runs_all_in_turn_and_begins_anew_when_it_is_used_up():
    count = EPISODES_A_PROCESS + 1

    assert predicted(ALIKE, count, 1) == pytest.approx(2 * 5.0 + count * 2.01)


def test_many_cores_share_the_episodes():
    assert predicted(ALIKE, 100, 10) == pytest.approx(5.0 + 10 * 2.0 + 0.5, abs=0.5)


def test_with_more_cores_than_episodes_one_episode_is_waited_for():
    assert predicted(ALIKE, 10, 1000) == pytest.approx(5.0 + 2.0 + 10 * 0.01)


def test_the_one_that_keeps_bounds_what_more_cores_gain():
    assert predicted(ALIKE, 10_000, 10_000) == pytest.approx(10_000 * 0.01 + 7.0, rel=0.01)
    assert predicted(ALIKE, 10_000, 2_000) > 10_000 * 0.01
