"""A refusal says what was understood, what was not, and what to say instead."""

import pytest

from executive.understanding.command_parser import parse


@pytest.mark.parametrize(
    ("said", "told"),
    [
        (
            "bring me the towel, cups see the window",
            "I understood 'bring me the towel'; I did not understand 'cups see the window'. Say only",
        ),
        (
            "bring me the towel, my hovercraft waits",
            "I understood 'bring me the towel'; the word 'hovercraft'",
        ),
        ("go to the kitchen, no, the office", "you corrected yourself ('no'): say the command once more"),
        ("pick up the cup, don't drop it", "I understood 'pick up the cup'"),
        ("pick up the heaviest cup", "cannot weigh things"),
        ("stop or I scream", "leaves open what is meant"),
    ],
)
def test_a_refusal_tells_what_was_understood(said, told):
    assert told in parse(said).refusal.message


@pytest.mark.parametrize(
    ("said", "plainly"),
    [
        ("pick up the red and blue cups", "pick up the red cups and the blue cups"),
        ("walk to the door of the kitchen", "walk to the kitchen door"),
        ("turn to the table", "look at the table"),
        ("turn to Ana", "look at Ana"),
    ],
)
def test_common_forms_mean_what_their_plain_wording_means(said, plainly):
    assert parse(said).to_json()["tasks"] == parse(plainly).to_json()["tasks"] != []
