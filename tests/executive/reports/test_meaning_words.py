"""What a person reads of a sentence that was understood."""

import pytest

from executive.meaning import command_json
from executive.reports.meaning_words import meaning_words
from executive.understanding.command_parser import parse


@pytest.mark.parametrize(
    ("said", "understood"),
    [
        ("grab the red mug on the table", ["pick up the red cup from the table"]),
        ("bring me the bottle", ["pick up the bottle", "give it to me"]),
        ("pick up both cups with your left hand", ["pick up the cup with the left hand (both)"]),
        ("take the cup and put it next to the can", ["pick up the cup", "place it next to the can"]),
        ("throw the can in the bin", ["put the can in the bin"]),
        ("give Ana's cup to Ben", ["give Ana's cup to Ben"]),
        ("walk to the chair next to the window", ["walk to the chair next to the window"]),
        ("walk forward 2 meters", ["move at 0.3 m/s for 2 m"]),
        ('say "hello" to Ben', ['say "hello" to Ben']),
        ("greet Ben", ["greet Ben"]),
        ("wave to Ana", ["wave to Ana"]),
        ("how many cups are there", ["count every cup"]),
        ("go home", ["go home"]),
    ],
)
def test_a_command_is_echoed_in_canonical_words(said, understood):
    parsed = parse(said)

    assert [meaning_words(command_json(task)) for task in parsed.commands] == understood


def test_a_name_of_the_scene_is_told_once_and_without_its_number():
    meaning = {"action": "pick", "object": {"kind": "cup", "color": "red", "name": "red cup 2"}}

    assert meaning_words(meaning) == "pick up the red cup"
