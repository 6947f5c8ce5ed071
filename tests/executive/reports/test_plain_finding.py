"""What the checker found is told in words, with the units of what was measured."""

import pytest

from executive.reports.plain_finding import plain_finding
from kinematics.motion.verdict import FindingKind


def numbers(finding, subject, value, limit):
    return {"finding": finding, "subject": subject, "value": value, "limit": limit, "t_s": 0.5}


@pytest.mark.parametrize(
    ("finding", "told"),
    [
        (("scene collision", "hand and table", 0.004, 0.015), "hand would come within 4 mm of table"),
        (("self-collision", "hand and thigh", -0.002, 0.01), "hand would come into thigh"),
        (("held object collision", "cup and shelf", 0.004, 0.015), "what is held, cup would come within"),
        (("velocity limit", "elbow", 3.2, 2.7), "elbow would have to move at 3.2 rad/s"),
        (("effort limit", "elbow", 52.0, 44.0), "44 Nm is the most that it may"),
        (("concession", "hand and cup", 0.1, 0.006), "hand and cup to come nearer"),
        (("balance", "left sole", 0.01, 0.03), "10 mm are left before it tips over"),
    ],
)
def test_a_finding_says_what_would_happen_and_what_is_allowed(finding, told):
    assert told in plain_finding(numbers(*finding))


def test_every_kind_of_finding_has_its_words_or_none():
    silent = {
        kind for kind in FindingKind if plain_finding(numbers(kind.value, "one and other", 1.0, 0.5)) is None
    }

    assert silent == {FindingKind.STANCE, FindingKind.DISCONTINUITY}


def test_nothing_is_said_of_numbers_that_are_missing():
    assert plain_finding({"finding": "balance"}) is None
