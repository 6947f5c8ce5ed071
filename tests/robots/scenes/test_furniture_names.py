"""Names of furniture that tell more than its kind, and what kind a name is of."""

import pytest

from robots.scenes.furniture_names import kind_called, kind_that_name_contradicts, own_name


@pytest.mark.parametrize(
    ("words", "kind"),
    [
        ("side table", "table"),
        ("desk", "table"),
        ("Ana's desk", "table"),
        ("table", "table"),
        ("fridge", "fridge"),
    ],
)
def test_the_last_word_tells_the_kind(words, kind):
    assert kind_called(words) == kind


@pytest.mark.parametrize(
    ("name", "kind", "own"),
    [
        ("side table", "table", "side table"),
        ("Desk 2", "table", "desk"),
        ("table", "table", None),
        ("table 2", "table", None),
        ("wall beside the table", "wall", None),
        ("beer fridge", "fridge", None),
        ("Bob", "table", None),
    ],
)
def test_only_what_says_more_than_the_kind_is_a_name(name, kind, own):
    assert own_name(name, kind) == own


@pytest.mark.parametrize(
    ("name", "kind", "told"),
    [
        ("fridge", "table", "fridge"),
        ("Fridge 2", "table", "fridge"),
        ("table", "shelf", "table"),
        ("desk", "counter", "table"),
        ("kitchen counter", "table", "counter"),
        ("chest", "fridge", "drawers"),
        ("chest", "drawers", None),
        ("beer fridge", "fridge", None),
        ("wall beside the table", "wall", None),
        ("table by the wall", "table", None),
        ("desk", "table", None),
        ("plate 3", "wall", None),
        ("Bob", "table", None),
        ("2", "table", None),
    ],
)
def test_a_name_that_is_one_of_another_kind_contradicts_its_own(name, kind, told):
    assert kind_that_name_contradicts(name, kind) == told
