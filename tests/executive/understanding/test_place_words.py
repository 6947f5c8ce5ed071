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


@pytest.mark.parametrize("said", ["bedside table", "nightstand", "night stand"])
def test_furniture_is_called_as_the_place_calls_it_by_whatever_word(said):
    with words_of_the_place(("bedside table",)):
        (task,) = parse(f"put the cup on the {said}").to_json()["tasks"]

    assert task["on"] == "bedside table"


def test_several_pieces_are_called_as_the_place_calls_one():
    with words_of_the_place(("bedside table",)):
        (command,) = parse("count the nightstands").commands

    assert command.object.kind == "bedside table"


def test_furniture_of_which_the_place_tells_more_keeps_its_short_name():
    with words_of_the_place(("kitchen counter",)):
        (task,) = parse("put the cup on the counter").to_json()["tasks"]

    assert task["on"] == "counter"
