"""Which door "the door" is, and where things are counted right after something was opened."""

import pytest

from executive.understanding.command_parser import parse


def tasks_of(sentence):
    return parse(sentence).to_json()["tasks"]


@pytest.mark.parametrize(
    ("sentence", "closed"),
    [
        ("put the milk back in the fridge and shut the door", {"kind": "fridge"}),
        ("take the coat out of the wardrobe and close the door", {"kind": "wardrobe"}),
        ("open the oven, put the pan in it, and close the door", {"ref": 0}),
        ("open the fridge, take the milk, put it on the table and close the door", {"ref": 0}),
        ("go to the kitchen and close the door", {"kind": "door"}),
        ("put the cup in the drawer and close the door", {"kind": "door"}),
        ("close the fridge and the door", {"kind": "door"}),
        ("put the milk in the fridge and close the kitchen door", {"kind": "door", "name": "kitchen door"}),
    ],
)
def test_the_door_is_that_of_what_was_used_just_now(sentence, closed):
    assert tasks_of(sentence)[-1] == {"action": "close", "object": closed}


@pytest.mark.parametrize(
    "sentence",
    [
        "put the milk in the fridge and the cup in the cupboard, then close the door",
        "open the fridge and the oven and close the door",
        "open the fridge, go to the hall and close the door",
        "open the door, put the milk in the fridge and close the door",
        "put the milk in the fridge, wave to Ana and close the door",
        "close the fridge and close the door",
    ],
)
def test_which_of_several_doors_is_asked(sentence):
    assert parse(sentence).outcome == "question"


def test_what_is_counted_after_an_opening_is_inside():
    assert tasks_of("go to the fridge, open it and tell me how many eggs are left")[-1]["from"] == {"ref": 1}
    red, blue = tasks_of("open the fridge, count the red boxes and the blue boxes")[1:]
    assert red["from"] == blue["from"] == {"ref": 0}


@pytest.mark.parametrize(
    "sentence",
    [
        "open the fridge, close it and count the eggs",
        "open the fridge, go to the kitchen and count the eggs",
        "open the fridge and the drawer and count the eggs",
        "open the fridge and count the people",
        "open the door and count the cups",
        "count the cups and open the fridge",
    ],
)
def test_nothing_is_counted_inside_what_is_not_looked_into(sentence):
    told = tasks_of(sentence)

    assert told != []
    assert all("from" not in one for one in told)
