"""A humanoid of a child's size with hands of three fingers, judged by the simulator's truth."""

import pytest

from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.skills.episode import run_skill_episode


@pytest.mark.requirement("U8")
def test_what_suits_its_hands_is_picked_and_truly_put_down():
    record = run_skill_episode("place", EpisodeOrder(9119, robot="g1", scene="low_tabletop"))

    assert record.claimed, record.failure
    assert record.truth
    assert not record.fell
    assert not record.furniture_contacts
