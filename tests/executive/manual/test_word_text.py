"""A person's words in the record of a run: they come back to the last digit, and nothing else is read."""

import numpy as np
import pytest

from executive.manual.word_text import read_word, write_word
from executive.manual.words import BaseJog, GripJog
from kinematics.following.jog_reference import HandJog, JointJog

WORDS = [
    HandJog("left", "tool", np.array([0.1, -0.0, 1 / 3]), np.array([0.0, 2 / 7, 0.0])),
    JointJog("arm_left_3_joint", -0.2 / 3),
    BaseJog(0.21, -0.1),
    GripJog("right", True),
    None,
]


@pytest.mark.parametrize("may_touch", [False, True])
@pytest.mark.parametrize("word", WORDS, ids=str)
def test_words_come_back_as_they_were(word, may_touch):
    read, touching = read_word(write_word(word, may_touch))

    assert repr(read) == repr(word)
    assert touching == may_touch


@pytest.mark.parametrize(
    "text",
    [
        "up",
        "[]",
        "7",
        '{"fly": 1}',
        '{"hand": "third", "frame": "world", "linear_m_s": [0, 0, 0], "angular_rad_s": [0, 0, 0]}',
        '{"hand": "left", "frame": "world", "linear_m_s": [0, 0], "angular_rad_s": [0, 0, 0]}',
        '{"joint": 3, "rate_rad_s": 0.1}',
        '{"base_m_s": true, "base_rad_s": 0}',
        '{"base_m_s": 1e999, "base_rad_s": 0}',
    ],
)
def test_what_is_no_word_is_not_read(text):
    with pytest.raises(ValueError):
        read_word(text)
