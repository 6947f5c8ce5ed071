"""What the checker found is told in words, with the units of what was measured."""

import pytest

from executive.reports.plain_finding import plain_finding
from kinematics.motion.verdict import Finding, FindingKind


def found(kind, subject, value, limit):
    return Finding(kind, 0.5, tuple(subject.split(" and ")), value, limit)


@pytest.mark.parametrize(
    ("finding", "told"),
    [
        (
            (FindingKind.SCENE_COLLISION, "hand and table", 0.004, 0.015),
            "hand would come within 4 mm of table",
        ),
        ((FindingKind.SELF_COLLISION, "hand and thigh", -0.002, 0.01), "hand would come into thigh"),
        (
            (FindingKind.HELD_OBJECT_COLLISION, "cup and shelf", 0.004, 0.015),
            "what is held, cup would come within",
        ),
        ((FindingKind.VELOCITY_LIMIT, "elbow", 3.2, 2.7), "elbow would have to move at 3.2 rad/s"),
        ((FindingKind.EFFORT_LIMIT, "elbow", 52.0, 44.0), "44 Nm is the most that it may"),
        ((FindingKind.CONCESSION, "hand and cup", 0.1, 0.006), "hand and cup to come nearer"),
        ((FindingKind.BALANCE, "left sole", 0.01, 0.03), "10 mm are left before it tips over"),
    ],
)
def test_a_finding_says_what_would_happen_and_what_is_allowed(finding, told):
    assert told in plain_finding(found(*finding))


def test_every_kind_of_finding_has_its_words_or_none():
    silent = {kind for kind in FindingKind if plain_finding(found(kind, "one and other", 1.0, 0.5)) is None}

    assert silent == {FindingKind.STANCE, FindingKind.DISCONTINUITY}
