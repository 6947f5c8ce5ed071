"""Which one of a row, several doors, plural places, weights and sorts of things."""

import json

import pytest

from executive.understanding.command_parser import parse


def tasks(text):
    return json.loads(json.dumps(parse(text).to_json()["tasks"]))


@pytest.mark.parametrize(
    "said", ["open both drawers", "open all doors", "close all the drawers", "close both of the doors"]
)
def test_several_doors_at_once_are_refused_with_what_can_be_said(said):
    refusal = parse(said).refusal

    assert "only one at a time" in refusal.message
    assert "name each of them" in refusal.message


@pytest.mark.parametrize(
    "said", ["put the cup between the bottle and the box", "bring me the cup between the bottle and the box"]
)
def test_between_two_things_is_refused_with_what_can_be_said(said):
    refusal = parse(said).refusal

    assert refusal.word == "between"
    assert "next to" in refusal.message


@pytest.mark.parametrize("said", ["put the cup on the tables", "bring me the cup from the tables"])
def test_which_of_several_places_is_asked(said):
    assert parse(said).question.text == "which one of the tables?"


def test_the_last_of_a_row_that_was_named_is_one_of_it():
    said = "there are three cups on the table. pick up the last one"

    assert tasks(said) == [{"action": "pick", "object": {"kind": "cup", "ordinal": "last"}, "from": "table"}]
    assert "nothing was named before" in parse("pick up the last one").question.text


@pytest.mark.parametrize(
    "said", ["pick up the lightest box", "bring me the cup next to the heaviest box", "find the heaviest can"]
)
def test_nothing_is_chosen_by_what_it_weighs(said):
    assert "cannot weigh" in parse(said).refusal.message


def test_which_is_the_heaviest_may_be_asked():
    assert tasks("tell me what is the heaviest drink on the desk") == [
        {"action": "describe", "object": {"kind": "drink", "size": "heaviest"}, "from": "desk"}
    ]


@pytest.mark.parametrize(
    ("one", "several", "kind"),
    [
        ("a drink", "drinks", "drink"),
        ("a snack", "snacks", "snack"),
        ("a food", "foods", "food"),
        ("a dish", "dishes", "dish"),
        ("a toy", "toys", "toy"),
        ("a fruit", "fruits", "fruit"),
        ("a cleaning supply", "cleaning supplies", "cleaning supply"),
    ],
)
def test_a_sort_of_things_is_a_kind(one, several, kind):
    assert tasks(f"take {one}") == [{"action": "pick", "object": {"kind": kind}}]
    assert tasks(f"how many {several} are on the table") == [
        {"action": "count", "object": {"kind": kind}, "from": "table"}
    ]


def test_a_room_that_is_described_is_where_to_look():
    assert tasks("describe the living room") == [{"action": "describe", "from": "living room"}]
