"""Verbs of picking up with a place that a thing goes to, and places that may be either."""

import pytest

from executive.understanding.command_parser import parse


def tasks_of(sentence):
    return parse(sentence).to_json()["tasks"]


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("lift the box onto the table", "put the box onto the table"),
        ("get the cup from the table into the sink", "put the cup from the table into the sink"),
        ("transfer the apple from the bowl to the plate", "put the apple from the bowl on the plate"),
        ("return the hammer to the toolbox", "put the hammer in the toolbox"),
        ("unload the boxes from the cart onto the bench", "put the boxes from the cart onto the bench"),
    ],
)
def test_what_is_brought_onto_or_into_something_is_put_there(said, meant):
    assert tasks_of(said) == tasks_of(meant) != []


@pytest.mark.parametrize("sentence", ["take the can in the trash", "pick up the paper in the trash"])
def test_in_the_trash_may_be_where_a_thing_is(sentence):
    assert parse(sentence).question is not None


@pytest.mark.parametrize("sentence", ["put the can in the trash", "throw the can in the trash"])
def test_in_the_trash_is_where_a_thing_is_thrown(sentence):
    assert tasks_of(sentence)[0]["to"] == "bin"


def test_grab_for_me_is_get_for_me():
    assert tasks_of("grab the cup for me") == tasks_of("get the cup for me") != []


def test_to_a_box_may_be_beside_it():
    assert tasks_of("move the cup to the box") == []
