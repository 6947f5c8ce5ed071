"""Trap words are few, and data."""

import pytest

from executive.front.trap_words import trap_words, traps_in


def test_there_are_forty_at_most():
    assert sum(map(len, trap_words().values())) <= 40


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("pick up the cup", ()),
        ("In case it rains, don’t pick it up", ("in case", "don't")),
        ("a notebook is nowhere near", ()),
        ("he SAID so, twice he said", ("said",)),
    ],
)
def test_they_are_found_as_words(text, found):
    assert traps_in(text) == found
