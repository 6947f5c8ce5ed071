"""What perception cannot tell is said before anything moves."""

import pytest

from executive.errands.impossible import impossible
from executive.understanding.command_parser import parse

LABELS = frozenset({"cup", "can", "box", "table", "fridge", "tomato soup", "drink", "soda", "door"})


def why(sentence, labels=LABELS):
    told = impossible(parse(sentence).commands, (), labels)
    return None if told is None else told.message


@pytest.mark.requirement("L11")
@pytest.mark.parametrize("sentence", ["find the rubik's cube", "pick up the rubik's cube"])
def test_a_thing_that_looks_like_nothing_known_is_said_at_once(sentence):
    assert why(sentence).startswith("I do not know what a rubik's cube looks like; I can find ")


def test_what_is_spelled_most_alike_is_told_first():
    assert "I can find a soda" in why("walk to the sofa")


@pytest.mark.requirement("L11")
@pytest.mark.parametrize(
    "sentence",
    [
        "pick up the mug",
        "find the tomato soup",
        "find the soup",
        "bring me a drink",
        "put the cup on the side table",
        "open the fridge",
        "wave to the doctor",
        "walk to Ana",
        "put the cup next to the can",
        "go home",
    ],
)
def test_what_can_be_told_or_is_no_thing_is_let_pass(sentence):
    assert why(sentence) is None


@pytest.mark.requirement("L11")
@pytest.mark.parametrize("sentence", ["put the cup next to the towel", "is there a towel on the table?"])
def test_what_something_is_compared_with_has_to_be_known_too(sentence):
    assert "what a towel looks like" in why(sentence)


def test_an_open_detector_may_be_asked_for_anything():
    assert why("find the rubik's cube", None) is None


def test_what_the_things_of_the_place_are_called_is_told_before_what_things_are_called_anywhere():
    labels = frozenset(
        {"ball", "bottle", "bowl", "box", "can", "cup", "counter", "door", "drawers", "fridge"}
    )

    said = why("find the rubik's cube", labels | {"table", "wall", "shelf", "zorblax", "handle", "drawer"})

    assert "I can find a zorblax, a ball" in said


def test_without_eyes_that_is_the_reason():
    found = impossible(parse("pick up the cup").commands, (), frozenset())

    assert found.message == "the robot has no eyes here to find a cup by"
    assert impossible(parse("wait for 2 seconds").commands, (), frozenset()) is None


@pytest.mark.parametrize("said", ["open the microwave", "close the microwave", "open the door of the fridge"])
def test_what_nobody_opens_is_told_before_anything_moves(said):
    told = why(said, LABELS | {"microwave"})

    assert told == ("a microwave is nothing that I can open or close" if "microwave" in said else None)


def test_what_can_be_found_is_told_as_people_call_it():
    told = why("find the sofa", LABELS | {"drawers", "drawer bottom", "drawer wall"})

    assert "a chest of drawers" in told
    assert "a drawers" not in told
    assert "drawer bottom" not in told
    assert "drawer wall" not in told
