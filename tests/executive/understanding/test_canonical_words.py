"""Words of a model's action are those of sentences, or they are refused."""

import json

import pytest

from executive.understanding.understanding import understand


def parsed(**slots):
    action = {"action": "pick", "object": {"kind": "cup", **slots}, "confidence": 0.9}
    return understand(json.dumps(action)).parsed


@pytest.mark.requirement("F1", "L7")
@pytest.mark.parametrize(
    ("slot", "word", "nearest"),
    [
        ("size", "purple", None),
        ("size", "bigg", "big"),
        ("size", "leftmost", None),
        ("material", "unobtainium", None),
        ("material", "woden", "wooden"),
        ("ordinal", "zeroth", None),
        ("ordinal", "secnd", "second"),
        ("ordinal", "leftmost from the right", None),
        ("ordinal", "red", None),
    ],
)
def test_a_word_that_sentences_do_not_know_there_is_refused_with_the_nearest(slot, word, nearest):
    refusal = parsed(**{slot: word}).refusal

    assert refusal is not None
    assert refusal.word == word
    assert f"the {slot} {word!r} is not known; the nearest is" in refusal.message
    assert nearest is None or refusal.message.endswith(f"the nearest is {nearest!r}")


@pytest.mark.parametrize(
    ("slot", "word", "canonical"),
    [
        ("size", "huge", "big"),
        ("size", "Largest", "biggest"),
        ("size", "medium-sized", "medium"),
        ("material", "porcelain", "ceramic"),
        ("material", "glass", "glass"),
        ("ordinal", "left-most", "leftmost"),
        ("ordinal", "right", "rightmost"),
        ("ordinal", "2nd", "second"),
        ("ordinal", "closest", "nearest"),
        ("ordinal", "another", "other"),
        ("ordinal", "second_from_right", "second_from_right"),
        ("ordinal", "3rd from the left", "third"),
        ("ordinal", "first from the right", "rightmost"),
    ],
)
def test_a_word_that_sentences_know_there_becomes_the_one_that_they_use(slot, word, canonical):
    (command,) = parsed(**{slot: word}).commands

    assert getattr(command.object, slot) == canonical


@pytest.mark.requirement("F1")
def test_the_thing_that_a_place_is_compared_with_is_held_against_the_lists_too():
    to = {"kind": "bottle", "size": "purple"}

    assert parsed(relation={"is": "next_to", "to": to}).refusal is not None


@pytest.mark.parametrize("said", ["Ana Maria", "ana maria"])
def test_a_person_of_two_names_is_called_by_both(said):
    action = {"action": "walk_to", "to": said, "confidence": 0.9}

    assert understand(json.dumps(action)).parsed.commands[0].to == "Ana Maria"


def test_of_two_words_both_have_to_be_names():
    action = {"action": "walk_to", "to": "Ana Zork", "confidence": 0.9}

    assert understand(json.dumps(action)).parsed.refusal.word == "Ana Zork"
