"""What people say at home: "us", fillers, statements."""

import pytest

from executive.understanding.command_parser import parse


def tasks_of(sentence):
    return parse(sentence).to_json()["tasks"]


@pytest.mark.parametrize(
    ("said", "means"),
    [
        ("bring us the cup", "bring me the cup"),
        ("come over to me, robot", "come to me"),
        ("bring me the cup, love", "bring me the cup"),
        ("show me where the cup is", "point at the cup"),
        ("the cups, bring them to me", "bring me the cups"),
        ("find the ball hiding under the sofa", "find the ball under the sofa"),
    ],
)
def test_it_means_the_same_as_the_plain_wording(said, means):
    assert tasks_of(said) == tasks_of(means) != []


@pytest.mark.parametrize(
    "sentence",
    [
        "wave to us",
        "get us both beers",
        "take the cup, um, the bowl",
        "go to the kitchen uh the bathroom",
        "give me um Ana the cup",
        "you put the cup on the table",
        "you open the fridge?",
        "take the cup you put on the table",
        "the milk goes in the fridge?",
        "clear the table",
        "hold the cup for a second",
        "open the fridge for a minute",
        "walk to the kitchen real quick",
        "pick up the spoon the fork",
        "bring me the cup, the red one and the bowl",
        "put the apple you are holding into the bowl",
        "bring the cup to me on the sofa",
        "open the fridge, close it and look inside",
        "pick up the red robot",
    ],
)
def test_what_leaves_something_open_is_asked_or_refused(sentence):
    assert tasks_of(sentence) == []


def test_the_other_drawer_of_a_desk_is_of_that_desk():
    first, second = tasks_of("open the top drawer of the desk and the bottom one")

    assert first["object"]["relation"] == second["object"]["relation"] == {"is": "in", "to": "desk"}
    assert (first["object"]["ordinal"], second["object"]["ordinal"]) == ("top", "bottom")


def test_what_was_stated_after_an_order_is_what_is_moved_next():
    told = tasks_of("go to the bedroom. my keys are on the bed. bring them")

    assert [one["action"] for one in told] == ["walk_to", "pick", "hand_over"]
    assert told[1]["from"] == "bed"
    assert tasks_of("pick up the cup. my keys are on the bed. bring them") == []


def test_another_drawer_is_one_though_a_command_stands_between():
    told = tasks_of("open the top drawer, then open the bottom one")

    assert [one["object"]["kind"] for one in told] == ["drawer", "drawer"]
    assert tasks_of("open the top drawer of the desk, then open the bottom one") == []
    assert tasks_of("open the fridge and the top drawer, then close the bottom one") == []
    assert tasks_of("pick up the cup. open the left one") == []
