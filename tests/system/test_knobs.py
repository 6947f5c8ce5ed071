"""Knobs are turned and buttons pressed by what the hand does, and not by what is believed."""

import pytest

from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.skills.episode import run_skill_episode

BY_PARTS = 481019
"""The wrist comes to its limit on the way: it was turned back in part alone, and called off."""

PRESSED = 40417


@pytest.mark.requirement("M2")
def test_a_stove_is_off_only_once_its_knob_is_turned_back():
    record = run_skill_episode("turn_knob", EpisodeOrder(BY_PARTS))

    assert record.outcome == "done"
    assert record.truth, record.failure


def test_a_small_humanoid_presses_a_button_with_the_edge_of_its_palm():
    record = run_skill_episode("press", EpisodeOrder(PRESSED, robot="g1", scene="low_tabletop"))

    assert record.outcome == "done"
    assert record.truth, record.failure
    assert not record.fell
