"""A humanoid of a child's size with hands of three fingers, judged by the simulator's truth."""

import pytest

from tools.evaluate.episode import run_episode
from tools.evaluate.orders import EpisodeOrder


@pytest.mark.requirement("U8")
def test_what_suits_its_hands_is_picked_and_truly_held():
    record = run_episode(EpisodeOrder(1, robot="g1", scene="low_tabletop"))

    assert record.claimed, record.failure
    assert record.truth
    assert not record.fell
    assert not record.furniture_contacts
