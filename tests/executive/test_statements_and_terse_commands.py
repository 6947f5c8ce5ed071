"""Statements that name a thing, commands without a verb or an object, and words that mean the same."""

import pytest

from executive.understanding.command_parser import parse

pytestmark = pytest.mark.requirement("L1", "L2")


def tasks(sentence):
    return parse(sentence).to_json()["tasks"]


@pytest.mark.parametrize(
    ("sentence", "plain"),
    [
        ("there is a cup on the table. bring it to me", "bring me the cup on the table"),
        ("my keys are on the shelf, please bring them to Ana", "bring my keys on the shelf to Ana"),
        ("there's a ball under the table, pick it up", "pick up the ball under the table"),
        ("I left my phone on the sofa, bring it to me", "bring me my phone on the sofa"),
        ("there are two cups on the table. take the red one", "take the red cup from the table"),
    ],
)
def test_it_is_what_a_statement_named(sentence, plain):
    assert tasks(sentence) == tasks(plain) != []


@pytest.mark.parametrize(
    "sentence",
    [
        "there is a cup on the table",
        "there is a cup on the table. go home",
        "the cup is on the table and the bottle is on the shelf. pick it up",
        "pick up the bottle. there is a cup on the table. put it on the shelf",
    ],
)
def test_a_statement_that_no_task_takes_up_makes_none(sentence):
    assert tasks(sentence) == []


@pytest.mark.parametrize(
    ("sentence", "plain"),
    [
        ("forward 2 m", "move forward 2 m"),
        ("wave left hand", "wave with your left hand"),
        ("left 90 degrees", "turn left 90 degrees"),
        ("look behind the box for the ball", "find the ball behind the box"),
    ],
)
def test_a_terse_command_means_what_the_whole_one_does(sentence, plain):
    assert tasks(sentence) == tasks(plain) != []


@pytest.mark.parametrize(
    "sentence",
    [
        "put on the hat",
        "take the hat, put on the hat",
        "place on the shelf",
        "walk to the table backwards",
        "turn left, then right 90 degrees",
        "left",
        "there is a red cup on the table. take the blue one",
    ],
)
def test_a_terse_command_is_not_read_into_other_sentences(sentence):
    assert tasks(sentence) == []


def test_from_there_is_the_place_that_was_named():
    assert tasks("walk to the table, and from there take the cup")[1]["from"] == "table"


@pytest.mark.parametrize(
    "sentence",
    [
        "put the cube into the box",
        "put the red block on the blue block, and the green one on top of that",
        "put the box at the sofa",
    ],
)
def test_what_could_be_meant_in_two_ways_is_asked(sentence):
    assert parse(sentence).question is not None


def test_by_is_beside():
    assert tasks("put the box by the sofa")[0]["to"] == {"relation": {"is": "next_to", "to": "sofa"}}


def test_they_may_be_one_person():
    assert tasks("find the person in the kitchen and greet them")[1]["action"] == "greet"


def test_several_words_for_stop_are_one():
    assert tasks("whoa, stop right there") == [{"action": "stop"}]


@pytest.mark.parametrize("sentence", ["pick up the mug and saw", "pick up the plate, then iron"])
def test_a_bare_noun_that_is_a_verb_too_is_no_thing_of_a_list(sentence):
    assert tasks(sentence) == []


def test_each_place_of_a_list_is_that_of_the_things_before_it():
    done = tasks("put the apple and the pear in the bowl and the box on the shelf")

    assert [task.get("to", task.get("on")) for task in done] == [{"kind": "bowl"}, {"kind": "bowl"}, "shelf"]


@pytest.mark.parametrize(
    "sentence",
    [
        "bring me the cup from the shelf, the blue one",
        "go to the red chair, the blue one",
        "give Ana the ball, the red ball",
        "walk to the table and put the cup in the bowl there",
    ],
)
def test_what_is_said_again_or_of_two_places_is_asked(sentence):
    assert parse(sentence).question is not None


@pytest.mark.parametrize("end", ["leave it there", "put it down", "put it on the table"])
def test_what_is_put_already_is_not_put_again(end):
    assert len(tasks(f"take the cup to the table and {end}")) == 2


@pytest.mark.parametrize("sentence", ["pick up the apple before me", "pick up the second largest box"])
def test_what_is_no_place_and_no_rank_is_refused(sentence):
    assert parse(sentence).refusal is not None


def test_a_thing_that_is_told_of_first_stands_at_the_beginning_of_a_clause():
    done = tasks("put the fork in the cupboard, hand it to Tom")

    assert done[0]["to"] == "cupboard"
    assert done[1]["object"] == {"ref": 0}


@pytest.mark.parametrize(
    ("sentence", "place"),
    [
        ("go to the fridge, then to the table, and take the ball from there", "table"),
        ("go to the table and take the ball from there, walk to the garage", "table"),
    ],
)
def test_there_is_where_the_robot_was_sent_just_now(sentence, place):
    assert next(task for task in tasks(sentence) if task["action"] == "pick")["from"] == place


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("go to the table\ntake the cup\ngo home", "go to the table. take the cup. go home"),
        ("pick up the\nred cup", "pick up the red cup"),
    ],
)
def test_lines_are_sentences_or_one_that_was_broken(text, plain):
    assert tasks(text) == tasks(plain) != []


def test_what_is_said_of_a_later_thing_may_not_hold_for_the_one_before():
    assert parse("get three cans from the fridge, then the fork to Ana").commands == ()


def test_what_stands_before_something_else_belongs_to_what_was_said_before_it():
    done = tasks("go to the table before you take the fork, then put the bottle on the bench")

    assert [task["action"] for task in done] == ["walk_to", "pick", "place"]
    assert parse("go to the table before you take the fork, bring me the can, hand it to Tom").commands == ()


def test_again_closes_what_was_opened_before():
    assert tasks("open the fridge, take the milk and close it again")[-1] == {
        "action": "close",
        "object": {"ref": 0},
    }


@pytest.mark.parametrize(
    ("sentence", "same"),
    [
        ("close the door again", "close the door"),
        ("open the fridge and close the drawer again", "open the fridge and close the drawer"),
        ("wave once more", "wave"),
        ("pick up the red cup and put it down again", "pick up the red cup and put it down"),
        ("once again, move forward", "move forward"),
    ],
)
def test_what_is_done_again_is_done(sentence, same):
    assert tasks(sentence) == tasks(same) != []


@pytest.mark.parametrize(
    "sentence", ["say see you again", "tell Ana that I will be here again", "say it again"]
)
def test_again_is_not_dropped_from_what_is_said(sentence):
    assert parse(sentence).commands == ()


def test_one_more_is_asked():
    assert parse("take a third apple").outcome == "question"
