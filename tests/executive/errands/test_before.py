"""What has to be true before a skill stands in its record, and is brought about."""

from dataclasses import dataclass

import pytest

from executive.errands.prepared import Known
from executive.errands.required import with_names
from executive.errands.unsaid_steps import prepared
from trees import registry
from trees.skill import Before, Skill
from trees.skills import built_in, follow, guide
from trees.tasks import (
    Destination,
    FindTask,
    ObjectDescription,
    OpenTask,
    PickTask,
    Thing,
    WalkToTask,
)

CUP = ObjectDescription("cup", "red")
IN_ROOMS = Known(rooms=frozenset({"kitchen", "hall"}))


@dataclass(frozen=True, slots=True)
class GreetTask:
    text: str
    person: Destination | None = None

    action = "greet"


@dataclass(frozen=True, slots=True)
class ShakeTask:
    text: str
    object: Thing
    hand: str | None = None
    count: int = 1
    source: Destination | None = None

    action = "shake"


@dataclass(frozen=True, slots=True)
class InspectTask:
    text: str
    source: Destination

    action = "inspect"


@dataclass(frozen=True, slots=True)
class FollowTask:
    text: str
    person: Destination

    action = "follow"


@pytest.fixture
def known_with(monkeypatch):
    """Makes the robot know one more skill."""

    def more(kind, **record):
        skill = Skill(task=kind, tree=None, example="it", **record)
        known = {**built_in(), kind.action: skill}
        monkeypatch.setattr(registry, "built_in", lambda: known)

    return more


def kinds(*commands, known=IN_ROOMS):
    return [type(step.command) for step in prepared(commands, True, known)]


def test_whom_a_skill_is_for_is_walked_to(known_with):
    known_with(GreetTask, before=frozenset({Before.AT_GOAL}))

    assert kinds(GreetTask("greet Ana", "Ana")) == [WalkToTask, GreetTask]


def test_a_skill_that_says_nothing_of_it_begins_at_once(known_with):
    known_with(GreetTask)

    assert kinds(GreetTask("greet Ana", "Ana")) == [GreetTask]


def test_what_a_skill_needs_in_a_hand_is_picked_up(known_with):
    known_with(ShakeTask, before=frozenset({Before.THING_AT_HAND, Before.THING_HELD}))

    assert kinds(ShakeTask("shake it", CUP)) == [WalkToTask, PickTask, ShakeTask]


def test_what_a_skill_only_needs_within_reach_is_walked_to(known_with):
    known_with(ShakeTask, before=frozenset({Before.THING_AT_HAND}))

    assert kinds(ShakeTask("shake it", CUP)) == [WalkToTask, ShakeTask]


def test_a_door_before_what_a_skill_takes_is_opened(known_with):
    known_with(ShakeTask, before=frozenset({Before.THING_AT_HAND, Before.SOURCE_OPEN}))

    done = kinds(ShakeTask("shake it", CUP, source="fridge"), known=Known())

    assert done == [WalkToTask, OpenTask, WalkToTask, ShakeTask]


def test_what_a_skill_is_asked_about_is_seen_from_before_it(known_with):
    known_with(InspectTask, before=frozenset({Before.SOURCE_IN_VIEW}))

    assert kinds(InspectTask("inspect the table", "table")) == [WalkToTask, InspectTask]


@pytest.mark.parametrize("source", ["kitchen", ObjectDescription("table")])
def test_where_somebody_is_said_to_be_is_walked_to_before_they_are_followed_or_led(source):
    followed = follow.FollowTask("follow Ana", "Ana", source=source)
    led = guide.GuideTask("guide Ana to the hall", "Ana", source=source, to="hall")

    assert kinds(followed) == [WalkToTask, follow.FollowTask]
    assert kinds(led) == [WalkToTask, guide.GuideTask]


def test_nobody_is_walked_to_who_is_not_said_to_be_anywhere():
    assert kinds(follow.FollowTask("follow Ana", "Ana")) == [follow.FollowTask]


def test_who_speaks_is_found_out_before_a_skill_takes_the_robot_away(known_with):
    known_with(FollowTask, goes_away=True)

    done = kinds(FollowTask("follow Ana", "Ana"), WalkToTask("come back", "me"), known=Known())

    assert done == [FindTask, FollowTask, WalkToTask]


def test_whom_me_means_is_found_out_before_a_skill_that_is_for_them_after_going_away(known_with):
    known_with(GreetTask, before=frozenset({Before.AT_GOAL}))
    away = WalkToTask("walk to the hall", "hall")

    done = kinds(away, PickTask("take it", CUP), GreetTask("greet me", "me"), known=Known())

    assert done[0] is FindTask


def test_who_was_found_is_the_one_that_a_skill_is_for(known_with):
    known_with(GreetTask, before=frozenset({Before.AT_GOAL}))

    assert with_names(GreetTask("greet me", "me"), {"me": "Ana"}) == GreetTask("greet me", "Ana")
