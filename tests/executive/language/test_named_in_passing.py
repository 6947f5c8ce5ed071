"""Who and what a statement names beside a command is what "her" and "it" may stand for after it."""

import itertools
import random

import pytest

from executive.understanding.command_parser import parse

STATES = [" is cold", " is really hungry", " is asleep", " is waiting for you", " is in the kitchen"]
ERRANDS = ["bring her a blanket", "wave to her", "tell her that dinner is ready", "hand her the cup"]


def tasks_of(text):
    answer = parse(text).to_json()
    assert answer["outcome"] == "tasks", text
    return answer["tasks"]


@pytest.mark.parametrize(("state", "errand"), list(itertools.product(STATES, ERRANDS)))
def test_somebody_of_whom_something_is_stated_is_who_is_meant(state, errand):
    assert tasks_of(f"Maria{state}. {errand}") == tasks_of(errand.replace(" her", " Maria"))


@pytest.mark.parametrize(("state", "errand"), list(itertools.product(STATES, ERRANDS)))
@pytest.mark.parametrize("mark", [".", ";", ","])
def test_somebody_who_was_named_before_is_not_taken_for_who_is_meant(state, errand, mark):
    assert parse(f"wave to Robin{mark} Grandma{state}{mark} {errand}").question is not None


@pytest.mark.parametrize("state", ["dirty", "empty", "broken", "very old"])
def test_a_thing_of_which_something_is_stated_is_what_is_taken(state):
    assert tasks_of(f"the plate is {state}, put it in the sink") == tasks_of("put the plate in the sink")


@pytest.mark.parametrize("statement", ["the plate is dirty", "Ana is hungry", "there is a cup on the table"])
def test_what_is_asked_is_no_statement(statement):
    assert parse(f"{statement}? Put it in the sink").to_json()["tasks"] == []


@pytest.mark.parametrize(
    "statement", ["Ana is hungry", "the plate is dirty", "I'm in the kitchen", "the kitchen is cold"]
)
def test_a_statement_alone_is_no_command(statement):
    assert parse(statement).refusal is not None


def test_a_place_that_is_named_in_passing_is_there():
    assert tasks_of("Ana is in the kitchen. Go there and wave to her") == tasks_of(
        "go to the kitchen and wave to Ana"
    )


def test_what_is_off_a_place_is_not_there():
    assert parse("the cup is off the table, pick it up").to_json()["tasks"] == []


def test_a_thing_that_is_to_be_clean_is_no_statement_of_how_it_is():
    assert parse("the cup should be clean. Bring it here").to_json()["tasks"] == []


@pytest.mark.parametrize("end", ["afterwards", "after that", "once that is done"])
def test_after_that_stands_before_what_it_is_said_of(end):
    assert tasks_of(f"open the fridge and {end} wave") == tasks_of("open the fridge, then wave")
    assert parse(f"open the fridge and wave {end}").commands == ()


@pytest.mark.parametrize("phrase", ["throw away the can", "throw the can away", "dispose of the can"])
def test_what_is_thrown_away_goes_into_the_bin(phrase):
    assert tasks_of(phrase) == tasks_of("throw the can in the bin")


@pytest.mark.parametrize("phrase", ["take a picture", "take a photo of Ana", "point the lamp at the table"])
def test_an_idiom_is_more_than_its_words(phrase):
    assert parse(phrase).refusal is not None


def test_look_is_no_courtesy_before_a_direction():
    assert parse("look forward").to_json()["tasks"] == []


def test_whose_a_thing_is_may_be_meant_too():
    assert tasks_of("take Ana's cup and give it to her")[-1]["to"] == "Ana"
    assert parse("wave to Robin, take Ana's cup and give it to her").question is not None


def test_somebody_for_whom_a_door_is_opened_may_be_meant():
    assert tasks_of("open the door for Ana and wave to her") == tasks_of("open the door and wave to Ana")


def test_glasses_of_somebody_are_asked_about():
    assert parse("bring me Ana's glasses").question is not None


def test_walking_a_distance_is_forward_and_moving_is_asked():
    assert tasks_of("walk 2 m") == tasks_of("walk 2 m forward")
    assert parse("move 2 m").question is not None


def test_pass_is_to_whoever_speaks():
    assert tasks_of("pass the salt") == tasks_of("pass me the salt")
    assert parse("give the salt").question is not None


@pytest.mark.parametrize(
    ("place", "relation"),
    [
        ("in the kitchen", {"is": "in", "to": "kitchen"}),
        ("at the door", {"is": "next_to", "to": "door"}),
        ("on the sofa", {"is": "on", "to": "sofa"}),
    ],
)
def test_somebody_who_is_named_may_be_told_to_be_somewhere(place, relation):
    for command in ("give the cup to Ana", "wave to Ana", "say hello to Ana", "go to Ana"):
        task = tasks_of(f"{command} {place}")[-1]

        assert {"name": "Ana", "relation": relation} in task.values(), command


def test_on_the_table_nobody_is():
    assert parse("give the cup to Ana on the table").to_json()["tasks"] == []


def test_everything_after_some_things_is_asked_about():
    assert parse("take the cup and the book and put everything on the table").question is not None
    assert tasks_of("put everything in the box")[0]["count"] == "all"


def test_a_door_is_opened_once():
    assert tasks_of("open the door, after that open the door and wave") == tasks_of("open the door and wave")


def test_what_is_returned_to_somebody_is_handed_over_and_without_a_thing_it_is_to_walk():
    assert tasks_of("return the cup to Ana") == tasks_of("give the cup to Ana")
    assert tasks_of("take the cup and return to Ana")[-1] == {"action": "walk_to", "to": "Ana"}


ORDERS = (
    "take the cup from the table",
    "bring Ana the plate",
    "open the fridge",
    "go to the kitchen",
    "wave to Tom",
    "put the book in the drawer",
    "walk 2 m",
    "find the bottle",
)
REASONS = ("I'm cold", "she's hungry", "they are full", "I'm on the sofa", "Grandma is asleep", "he's in bed")


def test_a_reason_among_orders_changes_none_of_them():
    rng = random.Random(20261123)
    for _ in range(400):
        orders = rng.sample(ORDERS, rng.randint(1, 3))
        place = rng.randint(0, len(orders))
        separator = rng.choice([". ", ", ", "; ", " and "])
        said = separator.join([*orders[:place], rng.choice(REASONS), *orders[place:]])
        tasks = parse(said).to_json()["tasks"]

        assert tasks in ([], tasks_of(separator.join(orders))), said


@pytest.mark.parametrize("mark", [".", ";", "!"])
def test_words_to_say_end_with_their_sentence_or_are_asked_about(mark):
    said = f"tell Ana that dinner is ready{mark} the keys are on the hook{mark} wave to Ana"

    assert parse(said).question is not None
