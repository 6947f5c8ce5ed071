"""A reason is passed over where it is no more than that: the command means what it means without it."""

import pytest

from executive.understanding.command_parser import parse

COMMANDS = [
    "open the fridge",
    "bring me the cup",
    "go back one metre",
    "wave to Ana",
    "take the cup to the kitchen",
]
REASONS = [
    "because I am freezing to death",
    "since the guests are coming",
    "so that I can get through",
    "as it is getting late",
    "because my back is killing me",
    "so nobody stumbles",
    "because of the noise",
]
MORE_THAN_REASONS = [
    "because I'm tired and the plate",
    "because I'm tired put the plate away",
    "because I want you to go home",
    "because I want to kill him",
    "because if not I will cry",
    "as soon as I am tired",
    "as you did",
    "so you can open the window",
    "because",
]


def tasks_of(sentence):
    return parse(sentence).to_json()["tasks"]


@pytest.mark.parametrize("reason", REASONS)
@pytest.mark.parametrize("command", COMMANDS)
def test_a_reason_behind_a_command_changes_nothing(command, reason):
    assert tasks_of(f"{command} {reason}") == tasks_of(command) != []


@pytest.mark.parametrize("command", COMMANDS)
def test_a_reason_before_a_command_changes_nothing(command):
    assert tasks_of(f"Because the rain is coming in, {command}") == tasks_of(command)


@pytest.mark.parametrize("reason", MORE_THAN_REASONS)
@pytest.mark.parametrize("command", COMMANDS)
def test_what_says_more_than_why_is_not_passed_over(command, reason):
    assert tasks_of(f"{command} {reason}") != tasks_of(command)


@pytest.mark.parametrize(
    "sentence",
    [
        "bring me the bottle because it is on the table",
        "bring me the cup because it's the red one",
        "bring the cup because Ana needs it",
        "bring me a cup because I need two",
        "put the cup on the table so that the handle faces me",
        "close the door as I leave",
        "give me the knife because I am angry",
    ],
)
def test_what_the_command_leaves_out_is_not_passed_over(sentence):
    assert parse(sentence).refusal is not None


def test_what_a_reason_names_may_be_meant_by_it():
    assert tasks_of("pick up the cup because the plate is hot. Put it on the shelf.") == []
    assert tasks_of("pick up the cup because it's dirty. Put it on the shelf.") != []
