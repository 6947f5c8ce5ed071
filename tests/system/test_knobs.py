"""A knob is turned as far as was asked, by what the hand does and not by what is believed."""

import pytest

from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.skills.episode import run_skill_episode

BY_PARTS = 481019
"""The wrist comes to its limit on the way: it was turned back in part alone, and called off."""


@pytest.mark.requirement("M2")
def test_a_stove_is_off_only_once_its_knob_is_turned_back():
    record = run_skill_episode("turn_knob", EpisodeOrder(BY_PARTS))

    assert record.outcome == "done"
    assert record.truth, record.failure
