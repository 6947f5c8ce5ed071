"""Household skills on the robot that balances on its own feet, judged by the simulator's truth."""

import pytest

from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.skills.episode import run_skill_episode


@pytest.mark.requirement("L3", "M3")
def test_a_person_is_truly_waved_at():
    record = run_skill_episode("wave", EpisodeOrder(0))

    assert record.claimed, record.failure
    assert record.truth
    assert not record.fell


@pytest.mark.requirement("M2", "M3")
def test_a_gift_is_let_go_when_the_person_pulls_and_is_truly_carried_away():
    record = run_skill_episode("hand_over", EpisodeOrder(1))

    assert record.claimed, record.failure
    assert record.truth
    assert record.numbers["carried_m"] >= 0.15
    assert not record.fell
    assert not record.furniture_contacts
