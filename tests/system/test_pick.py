"""The main job on the simulated robot, judged by the simulator's truth, with and without faults."""

import pytest

from tools.evaluate.episode import run_episode
from tools.evaluate.orders import EpisodeOrder


def harmless(record):
    """Whatever came out: no defect, no lie, no fall, no furniture touched."""
    assert record.outcome != "error", record.detail
    assert not record.false_success, record.failure
    assert not record.fell
    assert not record.furniture_contacts
    return True


@pytest.mark.requirement("M1", "M2")
@pytest.mark.parametrize(
    "order", [EpisodeOrder(0, scene="tabletop"), EpisodeOrder(1), EpisodeOrder(3)], ids=str
)
def test_the_red_cup_is_picked_and_truly_held(order):
    record = run_episode(order)

    assert harmless(record)
    assert record.claimed, record.failure
    assert record.truth
    assert record.slip_m <= 0.002
    assert record.com_margin_m >= 0.02
    assert record.friction_error == pytest.approx(0.0, abs=1e-9)


@pytest.mark.requirement("M2")
@pytest.mark.parametrize("fault", ["empty_grasp", "slip", "taken", "nothing_there"])
def test_an_object_that_is_not_in_the_hand_is_never_claimed(fault):
    record = run_episode(EpisodeOrder(5, fault=fault))

    assert harmless(record)
    assert record.fault_fired
    assert not record.truth
    assert not record.claimed
    assert record.failure_kind is not None


@pytest.mark.requirement("M2")
@pytest.mark.parametrize("fault", ["wrong_detection", "knocked", "too_close"])
def test_what_is_not_where_it_was_is_picked_after_another_look_or_given_up_honestly(fault):
    record = run_episode(EpisodeOrder(3, fault=fault))

    assert harmless(record)
    assert record.fault_fired
    assert not record.false_failure


@pytest.mark.requirement("M4")
def test_a_cup_that_is_moved_during_the_reach_is_picked_from_its_new_place():
    records = [run_episode(EpisodeOrder(seed, fault="moved")) for seed in (1, 3)]

    assert all(harmless(record) and not record.false_failure for record in records)
    assert any(r.recoverable and r.fault_fired and r.truth and r.claimed for r in records)
