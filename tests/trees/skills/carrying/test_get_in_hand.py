"""A skill that begins with its thing in a hand, whosever it is, gets it there by one function."""

from dataclasses import dataclass

import pytest

from tests.trees.conftest import RED_CUP
from trees.api import Before, Skill, Thing, get_in_hand
from trees.task_tree import TaskTree
from trees.tasks import ObjectDescription


@dataclass(frozen=True, slots=True)
class ShakeTask:
    text: str
    object: Thing
    hand: str | None = None
    count: int = 1
    source: str | None = None

    action = "shake"


SHAKE = Skill(
    task=ShakeTask,
    tree=lambda _task, toolbox: get_in_hand(toolbox),
    example="shake the cup",
    before=frozenset({Before.THING_AT_HAND, Before.THING_HELD}),
)


def in_hand(stage, task):
    return stage.play(TaskTree(task, SHAKE.tree(task, stage.toolbox), stage.toolbox))


def test_what_is_in_no_hand_is_picked_up_first(stage):
    tree = in_hand(stage, ShakeTask("shake it", ObjectDescription("cup", "red")))

    assert tree.status == "success"
    assert list(stage.told.scene.attached) == ["red cup"]


def test_what_is_in_a_hand_already_is_not_picked_again(stage):
    assert stage.play(stage.pick()).status == "success"
    picked = len(stage.events)

    tree = in_hand(stage, ShakeTask("shake it", RED_CUP.object))

    assert tree.status == "success"
    assert not [event for event in stage.events[picked:] if "fetch it" in str(getattr(event, "where", ""))]


@pytest.mark.parametrize("named", [None, ObjectDescription("bottle", "blue")])
def test_what_is_not_there_is_told(stage, named):
    assert in_hand(stage, ShakeTask("shake it", named)).status == "failure"
