"""By what a word means a thing."""

import pytest

from kinematics.scene.label import Label
from trees.beliefs.scene.labels import CalledBy, called_by, can_be_told

SOUP = Label("can", "red", ("tomato soup",), ("food", "groceries"))


@pytest.mark.parametrize(
    ("said", "by"),
    [
        ("tomato soup", CalledBy.NAME),
        ("Tomato-Soup", CalledBy.NAME),
        ("tomato soup can", CalledBy.NAME),
        ("can", CalledBy.KIND),
        ("soup", CalledBy.KIND),
        ("food can", CalledBy.KIND),
        ("food", CalledBy.CATEGORY),
        ("paint can", CalledBy.HEAD),
        ("chicken soup", None),
        ("tomato", None),
        ("cup", None),
        (None, CalledBy.KIND),
    ],
)
def test_a_thing_is_called_by_its_name_its_kind_or_its_sort(said, by):
    assert called_by(said, SOUP) == by


@pytest.mark.parametrize(
    ("said", "told"),
    [("can", True), ("paint can", True), ("soup", True), ("rubik's cube", False), ("canister", False)],
)
def test_what_no_label_is_like_cannot_be_told(said, told):
    assert can_be_told(said, {"can", "tomato soup"}) is told
