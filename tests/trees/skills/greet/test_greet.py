"""Greeting: the right person is faced, waved to and told hello; who is not there is not greeted."""

from dataclasses import replace

import pytest

from kinematics.requests.gesture import RaiseHandRequest
from kinematics.requests.step import NoPlan
from robots.fake.fake_world import person, table
from robots.scenes.scene_description import Region
from tests.trees.household_stage import asked, run, said
from trees.events import NodeChanged, Said
from trees.self_knowledge import Identity
from trees.skills.greet import SKILL, GreetTask
from trees.tasks import ObjectDescription

ANA, BEN = person("Ana", (1.3, 0.5)), person("Ben", (1.4, -0.5))
SITTING = replace(BEN, traits=("sitting", "red shirt"))
ROOMS = {
    "kitchen": Region("kitchen", (1.4, -1.5), (2.0, 2.2)),
    "hall": Region("hall", (1.4, 1.5), (2.0, 2.2)),
}


def greet(stage, who, *, introducing=False, source=None):
    return run(stage, GreetTask("greet", who, source, introducing))


def test_the_person_who_is_named_is_waved_to_and_told_hello(stage_with):
    stage = stage_with(BEN, ANA)

    tree = greet(stage, "Ana")

    assert tree.status == "success"
    assert tree.evidence["greeted"] == "Ana"
    assert tree.evidence["swings"] >= 3
    assert asked(stage, RaiseHandRequest)[0].towards_m[1] > 0.4
    assert [(e.text, e.to) for e in stage.events if isinstance(e, Said)] == [("Hello, Ana!", "Ana")]


@pytest.mark.requirement("L12")
def test_who_is_described_by_what_is_seen_is_greeted(stage_with):
    stage = stage_with(ANA, SITTING)

    greet(stage, ObjectDescription("person", traits=("sitting",)))

    assert said(stage) == ["Hello, Ben!"]


def test_who_is_said_to_be_in_a_room_is_not_taken_from_another(stage_with):
    stage = stage_with(person("Ana", (1.2, 0.5)), BEN, table())
    stage.toolbox = replace(stage.toolbox, places=ROOMS)

    greet(stage, ObjectDescription("person"), source="kitchen")

    assert said(stage) == ["Hello, Ben!"]


def test_of_two_people_in_a_room_somebody_says_which(stage_with):
    stage = stage_with(person("Cleo", (1.3, -0.9)), BEN, ANA)
    stage.toolbox = replace(stage.toolbox, places=ROOMS)

    tree = greet(stage, ObjectDescription("person"), source="kitchen")

    assert set(tree.failure.choice_names) == {"Ben", "Cleo"}
    assert not said(stage)


def test_nobody_is_greeted_who_is_not_there(stage_with):
    stage = stage_with(BEN)

    tree = greet(stage, "Ana")

    assert tree.status == "failure"
    assert "no Ana seen" in tree.failure.message
    assert not said(stage)


def test_the_robot_introduces_itself_by_what_it_is_told_of_itself(stage_with):
    stage = stage_with(ANA)
    stage.toolbox = replace(stage.toolbox, identity=Identity("Tally", "Lodestar"))

    greet(stage, "Ana", introducing=True)

    assert said(stage) == ["Hello, Ana! I am Tally, of the team Lodestar."]


def test_words_are_said_without_a_wave_where_none_can_be_planned_and_that_is_told(stage_with):
    stage = stage_with(person("Ana", (1.3, 0.2)))
    planning = stage.fake.planning
    stage.when("raise hand", lambda: setattr(planning, "no_plan", NoPlan("no room for the hand", {})))
    tree = greet(stage, "Ana")

    assert tree.status == "success"
    assert said(stage) == ["Hello, Ana!"]
    assert SKILL.claim("greet Ana", "", tree.evidence) == "greet Ana, without waving"


@pytest.mark.parametrize("far_m", [3.0, 4.0])
def test_who_stands_far_away_is_walked_to(stage_with, far_m):
    stage = stage_with(person("Ana", (far_m, 0.3)), walks=True)

    tree = greet(stage, "Ana")

    assert tree.status == "success"
    assert tree.evidence["away_m"] == pytest.approx(1.1, abs=0.1)


def test_who_is_said_to_be_in_another_room_is_looked_for_there(stage_with):
    stage = stage_with(person("Ana", (4.0, 0.3)), walks=True)
    stage.toolbox = replace(stage.toolbox, places={"kitchen": Region("kitchen", (4.0, 0.0), (2.0, 2.0))})

    tree = greet(stage, "Ana", source="kitchen")

    assert tree.status == "success"
    assert any("know the room" in event.where for event in stage.events if isinstance(event, NodeChanged))


def test_nobody_is_told_hello_who_is_neither_faced_nor_waved_to(stage_with):
    stage = stage_with(person("Ana", (1.0, 1.1)))
    stage.when("raise hand", lambda: setattr(stage.fake.planning, "no_plan", NoPlan("no room", {})))

    tree = greet(stage, "Ana")

    assert tree.status == "failure"
    assert not said(stage)


def test_who_has_walked_on_since_the_last_look_is_the_same_person(stage_with):
    stage = stage_with(person("Ana", (3.5, 0.6)), walks=True)
    stage.when("walk", lambda: stage.fake.world.move("Ana", (0.6, -0.8, 0.0)))

    tree = greet(stage, "Ana")

    assert tree.status == "success"
    assert tree.evidence["away_m"] <= 1.8
    assert [name for name in stage.told.scene.objects if name.startswith("Ana")] == ["Ana"]


def test_who_walks_aside_during_the_wave_is_waved_to_anew(stage_with):
    stage = stage_with(person("Ana", (1.3, 0.2)))
    stage.when("swing hand", lambda: stage.fake.world.move("Ana", (0.0, -0.8, 0.0)))

    tree = greet(stage, "Ana")

    assert said(stage) == ["Hello, Ana!"]
    first, second = asked(stage, RaiseHandRequest)
    assert (first.towards_m[1] > 0.0, second.towards_m[1] < -0.4) == (True, True)
    assert tree.attempts == 2
