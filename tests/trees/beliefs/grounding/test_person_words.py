"""What is seen of people, in words."""

import pytest

from trees.beliefs.grounding.person_words import looks_of, people_who, worn


@pytest.mark.parametrize(
    ("traits", "words"),
    [
        ((), ""),
        (("sitting",), "is sitting"),
        (("waving", "standing"), "is standing and waving"),
        (
            ("raising right arm", "red shirt", "sitting"),
            "is sitting and raising the right arm, in a red shirt",
        ),
        (("orange hat", "pointing left"), "is pointing to the left, in an orange hat"),
    ],
)
def test_somebody_is_described_by_posture_gesture_and_clothes(traits, words):
    assert looks_of(traits) == words


@pytest.mark.parametrize(
    ("traits", "count", "words"),
    [
        (("sitting",), 2, "two people who are sitting"),
        (("red shirt",), 1, "one person in a red shirt"),
        (("lying", "blue trousers"), 0, "no people who are lying in blue trousers"),
    ],
)
def test_people_are_told_with_what_they_have_in_common(traits, count, words):
    assert people_who(traits, count) == words


def test_a_pair_of_something_has_no_article():
    assert worn(["black shoes", "white dress", "red hat"]) == "black shoes, a red hat and a white dress"
