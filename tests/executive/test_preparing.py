"""What has to be done before a command, that nobody said."""

import pytest

from executive.command_parser import parse
from executive.preparing import prepared, spoken_by
from trees.tasks import FindTask, HandOverTask, ObjectDescription, OpenTask, PickTask, WalkToTask


def steps(sentence, can_walk=True):
    return prepared(parse(sentence).commands, can_walk)


def kinds(sentence):
    return [type(step.command) for step in steps(sentence)]


@pytest.mark.requirement("L2")
def test_bringing_something_out_of_the_fridge_means_going_there_opening_it_and_coming_back():
    assert kinds("bring me the bottle from the fridge") == [
        FindTask, WalkToTask, OpenTask, WalkToTask, PickTask, WalkToTask, HandOverTask,
    ]  # fmt: skip


def test_what_was_said_keeps_its_number():
    assert [step.said for step in steps("bring me the bottle from the fridge")] == [
        None, None, None, None, 0, None, 1,
    ]  # fmt: skip


def test_who_speaks_is_found_out_before_the_robot_goes_away():
    first = steps("bring me the bottle from the fridge")[0]

    assert first.finds_speaker
    assert first.command.person == "me"


def test_somebody_who_is_named_need_not_be_looked_for_first():
    assert FindTask not in kinds("bring Ana the bottle from the fridge")


def test_a_fridge_that_is_opened_by_the_same_sentence_is_opened_once():
    assert kinds("open the fridge and bring Ana the bottle from the fridge").count(OpenTask) == 1


def test_a_walk_that_was_said_is_not_walked_twice():
    said = "take the bottle from the fridge, walk to Ana and give it to her"

    assert [step.command.to for step in steps(said) if type(step.command) is WalkToTask][-1] == "Ana"
    assert kinds(said)[-3:] == [PickTask, WalkToTask, HandOverTask]


@pytest.mark.parametrize(
    "sentence",
    ["bring me the red cup from the table", "pick up the cup", "walk to the kitchen and open the fridge"],
)
def test_what_is_at_hand_is_done_as_it_was_said(sentence):
    commands = parse(sentence).commands

    assert tuple(step.command for step in steps(sentence)) == commands


def test_a_robot_that_cannot_walk_does_what_was_said_from_where_it_stands():
    said = steps("bring me the bottle from the fridge", can_walk=False)

    assert [type(step.command) for step in said] == [PickTask, HandOverTask]


def test_me_becomes_the_name_of_who_spoke():
    give = HandOverTask("give it to me", ObjectDescription("bottle"), "me")

    assert spoken_by(give, "Ana").to == "Ana"
    assert spoken_by(WalkToTask("walk to me", "me"), "Ana").to == "Ana"
    assert spoken_by(WalkToTask("walk to Ben", "Ben"), "Ana").to == "Ben"


def test_what_was_seen_inside_needs_no_opening():
    commands = parse("take the bottle from the fridge").commands

    steps = prepared(commands, True, in_view=lambda pick: pick.source == "fridge")

    assert [type(step.command) for step in steps] == [WalkToTask, PickTask]
