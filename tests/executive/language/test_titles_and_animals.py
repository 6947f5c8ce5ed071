"""Names with a title, and animals, which are seen and never handled."""

import pytest

from executive.understanding.command_parser import parse


def tasks_of(sentence):
    return parse(sentence).to_json()["tasks"]


@pytest.mark.parametrize(
    ("sentence", "person"),
    [
        ("wave to Mr. Schmidt", "Mr. Schmidt"),
        ("wave to mr schmidt", "Mr. Schmidt"),
        ("wave to Dr Chen", "Dr. Chen"),
        ("wave to Mr. John Smith", "Mr. John Smith"),
        ("wave to my aunt Rosa", "Aunt Rosa"),
        ("wave to nurse Ana", "Nurse Ana"),
    ],
)
def test_a_title_belongs_to_the_name_behind_it(sentence, person):
    assert tasks_of(sentence) == [{"action": "wave", "person": person}]


@pytest.mark.parametrize(
    "sentence",
    [
        "wave to Mr. and Mrs. Smith",
        "wave to Mr.",
        "take the cup to the doctor Ana",
        "wave to Mr. Smith and Ben not",
    ],
)
def test_what_has_no_name_behind_its_title_is_refused(sentence):
    assert parse(sentence).outcome == "refused"


def test_who_is_told_ends_where_the_message_begins():
    told = tasks_of("tell grandma Rosa is here")

    assert told == [{"action": "say", "text": "Rosa is here", "person": {"kind": "grandmother"}}]
    assert tasks_of("bring the cup to Mr. Smith, then wave to her") == []


@pytest.mark.parametrize(
    "sentence", ["find the cat", "look at the cat", "point at the cat", "count the cats"]
)
def test_an_animal_is_seen(sentence):
    (task,) = tasks_of(sentence)

    assert task["object"] == {"kind": "cat"}


@pytest.mark.parametrize(
    "sentence",
    [
        "pick up the cat",
        "put the cat in the microwave",
        "bring me the cat",
        "give the milk to the cat",
        "give the cat the milk",
        "put the cup on the cat",
        "take the ball from the dog",
        "walk to the dog",
        "find the cat and pick it up",
        "find the cup. find the cat. pick it up",
        "find the cup and the cat and bring them to me",
        "find the cat and walk to it",
        "bring me the ball behind the cat",
        "wave to the cat",
        "the cat goes in the box",
    ],
)
def test_an_animal_is_never_handled(sentence):
    assert tasks_of(sentence) == []
