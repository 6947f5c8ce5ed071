"""What several looks have told of a person is kept together; of postures the newest counts."""

import pytest

from trees.beliefs.scene.person_looks import PersonLooks


@pytest.mark.parametrize(
    ("looks", "traits"),
    [
        ([("sitting", "red shirt"), ("sitting",)], ("red shirt", "sitting")),
        ([("sitting",), ()], ("sitting",)),
        ([(), ("waving", "standing")], ("standing", "waving")),
        ([("sitting",), ("standing",)], ("standing",)),
        ([(), ()], ()),
    ],
)
def test_what_a_look_leaves_out_another_one_tells(looks, traits):
    person = PersonLooks()
    for told in looks:
        person = person.and_seen(told)

    assert person.traits == traits


@pytest.mark.parametrize(
    ("looks", "enough"),
    [
        ([("sitting",)], False),
        ([("sitting",), ("sitting",)], True),
        ([("red shirt",), ("red shirt",)], False),
        ([(), (), ("lying",)], True),
    ],
)
def test_two_looks_that_tell_the_posture_are_enough(looks, enough):
    person = PersonLooks()
    for told in looks:
        person = person.and_seen(told)

    assert person.enough is enough
