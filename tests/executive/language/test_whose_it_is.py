"""A thing that is named by whom it belongs to, or by who left it where it is."""

import pytest

from executive.understanding.command_parser import parse


def tasks_of(sentence):
    return parse(sentence).to_json()["tasks"]


@pytest.mark.parametrize(
    ("sentence", "plain"),
    [
        ("give Ana her cup", "give Ana's cup to Ana"),
        ("bring Ben back his red cup from the shelf", "bring Ben's red cup from the shelf to Ben"),
        ("take the nurse her gloves", "take the nurse's gloves to the nurse"),
    ],
)
def test_it_belongs_to_whoever_was_named_right_before(sentence, plain):
    assert tasks_of(sentence) == tasks_of(plain) != []


@pytest.mark.parametrize("sentence", ["give Ben her cup", "give me his cup", "give him his cup"])
def test_of_anybody_else_it_is_refused(sentence):
    refusal = parse(sentence).refusal

    assert refusal is not None
    assert refusal.word in ("his", "her")


def test_the_glasses_of_somebody_may_be_those_to_drink_from():
    assert tasks_of("hand Grandma her glasses") == []


@pytest.mark.parametrize(
    "who", ["that Ana left", "which Ana has left", "that Ana put", "that my son dropped"]
)
def test_who_put_a_thing_where_it_is_cannot_be_seen(who):
    assert tasks_of(f"take the cup {who} on the table") == []


@pytest.mark.parametrize("sentence", ["open the door of the fridge", "shut the door of the fridge"])
def test_the_door_of_something_is_opened_as_the_thing_is(sentence):
    assert tasks_of(sentence)[0]["object"] == {"kind": "fridge"}


def test_one_of_two_doors_of_something_is_not_the_thing():
    door = {"kind": "door", "ordinal": "leftmost", "relation": {"is": "in", "to": "cupboard"}}
    assert tasks_of("open the left door of the cupboard") == [{"action": "open", "object": door}]


def test_the_door_to_a_room_is_the_door_of_the_room():
    assert tasks_of("open the door to the garden") == tasks_of("open the garden door") != []


def test_a_statement_of_what_somebody_has_can_be_told():
    assert tasks_of("tell Ana her tea is ready") == [
        {"action": "say", "text": "her tea is ready", "person": "Ana"}
    ]
    assert tasks_of("tell Ana her name") == []
