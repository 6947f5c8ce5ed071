"""How far "before", "after", "first", a hand and a pronoun reach: as is plain, or it is asked."""

import pytest

from executive.understanding.command_parser import parse

pytestmark = pytest.mark.requirement("L2", "L5")


def actions(sentence):
    return [task["action"] for task in parse(sentence).to_json()["tasks"]]


@pytest.mark.parametrize(
    ("sentence", "order"),
    [
        ("before you close the fridge, take the milk and put it on the table", "pick place close"),
        ("before closing the fridge, take the milk. Then go home.", "pick close go_home"),
        ("wave to Ana. Before opening the fridge, go home.", "wave go_home open"),
        ("wave to Ana, then open the fridge after going to the kitchen", "wave walk_to open"),
        ("after opening the fridge, take the milk and wave", "open pick wave"),
        ("before bringing me the cup, open the fridge", "open pick hand_over"),
    ],
)
def test_what_is_said_before_or_after_is_done_so(sentence, order):
    assert actions(sentence) == order.split()


@pytest.mark.parametrize(
    "sentence",
    [
        "go to the kitchen and wave after opening the fridge",
        "open the fridge after you go to the kitchen and wave to Ana",
        "before you go home, open the fridge, then wave",
        "2. open the fridge 1. go to the kitchen",
    ],
)
def test_an_order_that_could_be_two_is_asked_for(sentence):
    assert parse(sentence).question is not None


@pytest.mark.parametrize(
    "sentence",
    [
        "take the cup, the fork and the bowl and put both of them on the table",
        "take the box on the bench, the one next to the can",
        "take the cup, the red one, and the bottle",
        "tell Sam that Kim is in the kitchen and go to him",
        "say put the can on the table",
    ],
)
def test_what_may_lean_on_something_else_is_asked_about(sentence):
    assert parse(sentence).question is not None


@pytest.mark.parametrize(
    "sentence",
    [
        "give the bowl to Ana, no, give me the cup",
        "put the spoon in the drawer, forget that, put the red cup down",
        "fetch a blanket for Ana, I mean grab the red cup",
        "go to the table together with Ana",
        "please stop giving Ana a wave",
        "right, open the fridge",
        "go to the kitchen and wave, but first open the fridge",
        "open the fridge first, then take the milk",
        "go home, open the fridge first, then wave",
        "after opening the fridge and taking the milk, wave",
        "right hand: bowl onto tray",
    ],
)
def test_nothing_is_taken_from_one_command_for_another(sentence):
    assert actions(sentence) == []


def test_what_is_done_after_something_needs_no_comma_before_it():
    sentence = "wave to Ana, then after opening the fridge go to the kitchen"

    assert actions(sentence) == ["wave", "open", "walk_to"]


def test_both_are_the_two_that_were_named():
    tasks = parse("take the cup and the bowl and put both on the table").to_json()["tasks"]

    assert [task.get("object") for task in tasks[2:]] == [{"ref": 0}, {"ref": 1}]


def test_a_meter_and_a_half_is_one_and_a_half():
    (task,) = parse("move forward a meter and a half").to_json()["tasks"]

    assert task["distance_m"] == 1.5


@pytest.mark.parametrize("joined", ["and", "&", "n"])
def test_and_reaches_as_far_however_it_is_written(joined):
    said = parse(f"go to the kitchen {joined} wave after opening the fridge")

    assert said.question is not None
