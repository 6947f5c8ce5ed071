"""A noun that is said again with less than before: the same thing, another one, or a question."""

import pytest

from executive.understanding.command_parser import parse


def _tasks(sentence):
    answer = parse(sentence).to_json()
    assert answer["outcome"] == "tasks", answer
    return answer["tasks"]


def test_what_is_held_is_not_picked_up_twice():
    tasks = _tasks("take the big red cup and bring the cup to Ana")

    assert [one["action"] for one in tasks] == ["pick", "hand_over"]
    assert tasks[1]["object"] == {"ref": 0}


def test_the_drawer_that_was_opened_is_the_one_that_is_filled_and_closed():
    tasks = _tasks("open the left drawer, put the ball in the drawer and close the drawer")

    assert tasks[1]["to"] == {"ref": 0}
    assert tasks[2]["object"] == {"ref": 0}


def test_a_place_and_a_person_are_told_as_they_were():
    tasks = _tasks("go to the man in the kitchen and give the man the cup")

    assert tasks[1]["to"] == {"kind": "man", "relation": {"is": "in", "to": "kitchen"}}


@pytest.mark.parametrize(
    "sentence",
    [
        "take the red cup, then take a cup",
        "take the red cup from the table and take the cup from the shelf",
        "take the red cup to Ana and the cup to Ben",
    ],
)
def test_another_one_stays_another_one(sentence):
    objects = [one["object"] for one in _tasks(sentence) if one["action"] == "pick"]

    assert objects == [{"kind": "cup", "color": "red"}, {"kind": "cup"}]


@pytest.mark.parametrize(
    "sentence",
    [
        "take the red cup and the blue cup and put the cup on the table",
        "take the two red cups and give the cup to Ana",
        "bring me the red cup and put the cup on the table",
        "take the red cup and put it next to the cup",
        "take the cup from the big table and put it on the table",
    ],
)
def test_what_may_be_either_is_asked(sentence):
    assert parse(sentence).to_json()["outcome"] == "question"


@pytest.mark.parametrize("then", ["put it on the table", "bring it to Ana"])
def test_what_was_handed_over_without_being_picked_up_is_given_away(then):
    assert parse(f"pass the cup and {then}").question is not None


def test_what_was_brought_to_nobody_is_put_where_it_is_said_to_go():
    assert [one["action"] for one in _tasks("bring the cup and put it on the table")] == ["pick", "place"]


def test_what_was_on_the_left_is_put_down_though_another_one_is_by_then():
    tasks = _tasks("take the cup on the left and the one on the right and put the left one in the sink")

    assert tasks[2]["object"] == {"ref": 0}
