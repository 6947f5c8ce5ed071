"""Commands of a field's exam, drawn at random, are understood as they are meant, and none otherwise."""

import json

import pytest

from executive.understanding.command_parser import parse
from tools.evaluate.gpsr.field_commands import Drawn

MANY = 300


def is_wrong(command, tasks):
    """Whether tasks are others than those that a command asks for."""
    if len(tasks) != len(command.does):
        return True
    return any(
        (action and task["action"] != action) or (named and named.split()[-1] not in json.dumps(task))
        for (action, named), task in zip(command.does, tasks, strict=True)
    )


def measured(commands):
    answers = [(command, parse(command.says).to_json()["tasks"]) for command in commands]
    wrong = [(command.says, tasks) for command, tasks in answers if tasks and is_wrong(command, tasks)]
    lost = [command.says for command, tasks in answers if not tasks]
    return wrong, lost


@pytest.mark.requirement("L9")
@pytest.mark.parametrize(("category", "at_most_lost"), [("objects", 0.03), ("people", 0.05)])
def test_commands_of_the_field_are_understood_and_none_is_misunderstood(category, at_most_lost):
    wrong, lost = measured(getattr(Drawn(2026), category)(MANY))

    assert wrong == []
    assert len(lost) <= at_most_lost * MANY, lost
