"""An arm that is bolted down does the tasks of a bench, judged by the simulator's truth."""

import pytest

from tools.evaluate.episode import run_episode
from tools.evaluate.opening.episode import OpeningOrder, run_opening
from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.skills.episode import run_skill_episode


def on_the_bench(seed, scene="bench"):
    return EpisodeOrder(seed, robot="panda", scene=scene)


@pytest.mark.requirement("U8")
@pytest.mark.parametrize("scene", ["bench", "bench_clutter"])
def test_a_cup_is_picked_and_truly_held(scene):
    record = run_episode(on_the_bench(2, scene))

    assert record.claimed, record.failure
    assert record.truth
    assert not record.furniture_contacts


@pytest.mark.requirement("U8")
@pytest.mark.parametrize("suite", ["place", "put_in", "point_at", "find", "count", "describe"])
def test_a_skill_is_truly_done(suite):
    record = run_skill_episode(suite, on_the_bench(1))

    assert record.outcome == "done", record.failure
    assert record.truth, record.failure
    assert not record.furniture_contacts


@pytest.mark.parametrize("fault", ["empty_grasp", "nothing_there"])
def test_what_is_not_in_the_hand_is_never_claimed(fault):
    record = run_episode(EpisodeOrder(5, robot="panda", scene="bench", fault=fault))

    assert record.outcome != "error", record.failure
    assert not record.truth
    assert not record.claimed


@pytest.mark.parametrize("suite", ["open", "close"])
def test_a_drawer_is_opened_and_closed(suite):
    record = run_opening(OpeningOrder(suite, 2, "panda", where="bench_drawers"))

    assert record.outcome == "done", record.failure
    assert record.opening > 0.25 if suite == "open" else record.opening < 0.02
