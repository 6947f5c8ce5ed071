"""Text is bounded before anything looks at it."""

import pytest

from executive.language.text.tokens import MAX_LENGTH, MalformedTextError, normalise, pieces_of


def test_text_has_single_spaces_and_plain_quotes():
    assert normalise("  I\u2019d\tLIKE \n it ") == "I'd LIKE it"


def test_compatibility_characters_are_replaced():
    assert normalise("\uff30\uff49\uff43\uff4b") == "Pick"


def test_text_that_grows_when_it_is_normalised_is_refused_too():
    with pytest.raises(MalformedTextError):
        normalise("\ufdfa" * (MAX_LENGTH // 2))


def test_the_offending_character_is_named():
    with pytest.raises(MalformedTextError) as refused:
        normalise("pick\x07")
    assert refused.value.word == "U+0007"


@pytest.mark.parametrize(
    ("text", "pieces"),
    [
        ("Pick up the cup.", ["pick", "up", "the", "cup"]),
        ("turn left 90\u00b0", ["turn", "left", "90", "\u00b0"]),
        ("move 0.5m", ["move", "0.5", "m"]),
        ("the red-colored cup", ["the", "red", "colored", "cup"]),
        ("pick_up the red_cup", ["pick", "up", "the", "red", "cup"]),
        ("move_forward", ["move_forward"]),
        ("go -5 m", ["go", "-", "5", "m"]),
        ("say 'I am here' to Ana's dog", ["say", "I am here", "to", "ana's", "dog"]),
        ("the 2nd cup", ["the", "2nd", "cup"]),
    ],
)
def test_text_is_split_into_words_numbers_marks_and_quotations(text, pieces):
    assert [piece.text for piece in pieces_of(normalise(text))] == pieces


def test_a_sentence_of_too_many_words_is_refused():
    with pytest.raises(MalformedTextError, match="words"):
        pieces_of("a " * 100)
