"""By what a word means a thing."""

import pytest

from kinematics.scene.label import Label
from trees.beliefs.scene.labels import CalledBy, called_by, can_be_told, is_of_color

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


@pytest.mark.parametrize(
    ("color", "said", "label", "is_so"),
    [
        ("red", "can", SOUP, True),
        ("white", "can", SOUP, False),
        ("black", "book", Label("book", "white", ("black book",)), True),
        ("black", "bowl", Label("bowl", "white", ("akita black bowl",)), False),
        ("black", "bowl", Label("bowl", None, ("akita black bowl",)), True),
        ("black", None, Label("book", "white", ("black book",)), False),
        (None, "book", Label("book", "white", ("black book",)), True),
    ],
)
def test_a_thing_has_the_colour_that_is_seen_or_that_it_is_named_by(color, said, label, is_so):
    assert is_of_color(color, said, label) is is_so
