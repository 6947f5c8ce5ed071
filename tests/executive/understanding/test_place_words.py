"""What the things of a place are called is understood there, and nowhere else."""

import pytest

from executive.understanding.command_parser import parse
from executive.vocabulary.place_words import words_of_the_place
from trees.tasks import ObjectDescription

PLACE = ("zorblax", "macaroni and cheese", "groceries", "Tomato-Soup", "cup")


def meant(sentence):
    with words_of_the_place(PLACE):
        parsed = parse(sentence)
    assert parsed.refusal is None
    assert parsed.question is None
    return [command.object for command in parsed.commands if isinstance(command.object, ObjectDescription)]


@pytest.mark.parametrize(
    ("sentence", "kinds"),
    [
        ("pick up the zorblax", ["zorblax"]),
        ("find the zorblaxes", ["zorblax"]),
        ("bring me the macaroni and cheese", ["macaroni and cheese"]),
        ("put the macaroni and the cheese on the table", ["macaroni", "cheese"]),
        ("bring me the groceries", ["groceries"]),
        ("pick up the tomato soup", ["tomato soup"]),
        ("take the mug", ["cup"]),
    ],
)
def test_a_thing_of_the_place_is_called_as_it_is_there(sentence, kinds):
    assert [one.kind for one in meant(sentence)] == kinds


def test_a_word_of_one_place_is_not_known_elsewhere():
    meant("pick up the zorblax")

    assert parse("pick up the zorblax").refusal.word == "zorblax"
