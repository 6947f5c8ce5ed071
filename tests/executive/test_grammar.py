"""Every parse of a sentence is found, and their number is bounded."""

import pytest

from executive.grammar import Grammar, NoParse, TooManyParsesError
from executive.tokens import Word
from executive.vocabulary import Reading, load_vocabulary


@pytest.fixture(scope="module")
def grammar():
    return Grammar(load_vocabulary())


def word(*readings):
    return Word("x", tuple(Reading(*reading.split(":")) for reading in readings), 0, 1)


PICK, THE, CUP = word("PICK:pick"), word("DET:the"), word("KIND:cup")


def test_a_sentence_with_one_reading_has_one_parse(grammar):
    assert len(grammar.parses([PICK, THE, CUP])) == 1


def test_a_word_with_two_fitting_readings_gives_two_parses(grammar):
    trees = grammar.parses([PICK, THE, word("KIND:cup", "KIND:can")])

    kinds = {str(next(tree.find_data("kind")).children[0]) for tree in trees}
    assert kinds == {"cup", "can"}


def test_a_reading_that_does_not_fit_is_dropped(grammar):
    assert len(grammar.parses([PICK, THE, word("KIND:can", "PICK:pick")])) == 1


def test_where_a_sentence_breaks_off_is_told_with_what_would_fit(grammar):
    found = grammar.parses([PICK, THE, PICK])

    assert isinstance(found, NoParse)
    assert found.position == 2
    assert {"KIND", "COLOR", "DET"} <= found.expected
    assert "PICK" not in found.expected


def test_too_many_readings_are_given_up_instead_of_taking_for_ever(grammar):
    ambiguous = word("DET:the", "DET:a")

    with pytest.raises(TooManyParsesError):
        grammar.parses([PICK, *[ambiguous] * 40, CUP])
