"""What stands before its command: the thing that is "it" there, and the place where it is."""

import pytest

from executive.understanding.command_parser import parse


def tasks_of(sentence):
    return parse(sentence).to_json()["tasks"]


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("the red cup: pick it up", "pick up the red cup"),
        ("the bowl on the table: put it in the sink", "put the bowl from the table in the sink"),
        ("the box next to the sofa, bring it here", "bring the box next to the sofa here"),
        ("in the kitchen, take the red cup", "take the red cup from the kitchen"),
        ("wave to Ana. In the kitchen, find the cup", "wave to Ana. Find the cup in the kitchen"),
    ],
)
def test_it_is_told_as_it_is_behind_the_command(said, meant):
    assert tasks_of(said) == tasks_of(meant) != []


@pytest.mark.parametrize(
    "sentence",
    [
        "in the kitchen, put the cup on the table",
        "find the cup, in the kitchen, take the bowl",
        "the cup there, pick it up",
        "the cups on the table, pick it up",
    ],
)
def test_what_may_belong_to_something_else_is_not(sentence):
    assert tasks_of(sentence) == []


@pytest.mark.parametrize("behind", ["too", "as well"])
def test_where_the_last_of_several_goes_is_said_of_it_too(behind):
    assert tasks_of(f"put the box on the shelf and the can {behind}") == []


def test_who_takes_a_thing_along_may_take_it_before_going():
    assert tasks_of("go to Mia and take the folder with you") == []
