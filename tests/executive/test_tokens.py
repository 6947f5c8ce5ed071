"""Text is bounded before anything looks at it."""

import pytest

from executive.tokens import MAX_LENGTH, MalformedTextError, normalise


def test_text_is_lower_case_with_single_spaces_and_plain_quotes():
    assert normalise("  I\u2019d\tLIKE \n it ") == "i'd like it"


def test_compatibility_characters_are_replaced():
    assert normalise("\uff30\uff49\uff43\uff4b") == "pick"


def test_text_that_grows_when_it_is_normalised_is_refused_too():
    with pytest.raises(MalformedTextError):
        normalise("\ufdfa" * (MAX_LENGTH // 2))


def test_the_offending_character_is_named():
    with pytest.raises(MalformedTextError) as refused:
        normalise("pick\x07")
    assert refused.value.word == "U+0007"
