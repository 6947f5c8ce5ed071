"""Verbs of picking up with a place that a thing goes to, and places that may be either."""

import pytest

from executive.understanding.command_parser import parse


def tasks_of(sentence):
    return parse(sentence).to_json()["tasks"]


@pytest.mark.parametrize(
    "sentence",
    [
        "lift the box onto the table",
        "get the cup from the table into the sink",
        "unload the boxes from the cart onto the bench",
    ],
)
def test_a_verb_of_taking_says_nothing_of_where_a_thing_goes(sentence):
    assert parse(sentence).refusal is not None


@pytest.mark.parametrize(
    "sentence", ["transfer the apple from the bowl to the plate", "move the cup to the box"]
)
def test_to_a_thing_may_be_into_it_or_beside_it(sentence):
    assert parse(sentence).question is not None


@pytest.mark.parametrize("sentence", ["take the can in the trash", "pick up the paper in the trash"])
def test_in_the_trash_may_be_where_a_thing_is(sentence):
    assert parse(sentence).question is not None


@pytest.mark.parametrize("sentence", ["put the can in the trash", "throw the can in the trash"])
def test_in_the_trash_is_where_a_thing_is_thrown(sentence):
    assert tasks_of(sentence)[0]["to"] == "bin"


def test_grab_for_me_is_get_for_me():
    assert tasks_of("grab the cup for me") == tasks_of("get the cup for me") != []
