"""Small words that a speaker says twice, with and without a pause: the sentence means the same."""

import random

import pytest

from executive.understanding.command_parser import parse
from tests.executive.test_corpus import SENTENCES

COMMANDS = [
    one["say"]
    for one in SENTENCES
    if one["outcome"] == "tasks" and not any(task["action"] == "say" for task in one["tasks"])
]


def _again(sentence, draw):
    """The sentence with one small word said twice, or None where it has none."""
    words = sentence.split(" ")
    places = [index for index, word in enumerate(words) if word.lower() in ("the", "a", "my", "to", "and")]
    if not places:
        return None
    place = draw.choice(places)
    return " ".join([*words[: place + 1], *draw.choice(([], ["uh"])), *words[place:]])


def test_a_word_that_is_said_again_changes_nothing():
    draw = random.Random(20261123)
    changed = [
        again
        for sentence in draw.sample(COMMANDS, 600)
        if (again := _again(sentence, draw)) is not None
        and (answer := parse(again).to_json())["outcome"] == "tasks"
        and answer["tasks"] != parse(sentence).to_json()["tasks"]
    ]

    assert changed == []


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("pick up the the red ball", "pick up the red ball"),
        ("go to the uh to the hallway", "go to the hallway"),
        ("take the cup and the and the bowl", "take the cup and the bowl"),
    ],
)
def test_it_is_passed_over(said, meant):
    assert parse(said).to_json()["tasks"] == parse(meant).to_json()["tasks"] != []


@pytest.mark.parametrize("sentence", ["pick up the cup cup", "wait ten ten seconds"])
def test_words_that_say_something_are_not(sentence):
    assert parse(sentence).commands == ()
