"""When a question is put: not before arms that may hide what has gone are out of the way."""

import base64
from dataclasses import replace

import pytest
from py_trees.common import Status

from kinematics.requests.pick import PickRequest
from robots.fake.fake_world import cup, table
from robots.fake.scripted_detector import PICTURE
from tests.trees.leaf_inputs import believe
from trees.beliefs.grounding.grounding import exactly
from trees.events import ThingPictured
from trees.failures import Failure, OpenChoice
from trees.policy import Gaze
from trees.skills.looking.search import looking_from_home_is_useless, search
from trees.tasks import ObjectDescription, PickTask

CUP = PickTask("pick up the cup", ObjectDescription("cup"))


@pytest.mark.requirement("L6")
@pytest.mark.parametrize(("unseen", "useless"), [(0, True), (1, False)])
def test_of_several_things_one_that_was_not_seen_may_be_gone(unseen, useless):
    failure = Failure.asking("which cup? there are 2", OpenChoice(("left", "right"), unseen=unseen))

    assert looking_from_home_is_useless(failure) is useless


def test_a_defect_is_not_looked_past():
    assert looking_from_home_is_useless(Failure.error("it broke"))


@pytest.mark.requirement("L6")
def test_what_another_task_has_seen_counts_as_unseen(stage_with):
    stage = stage_with(table(), cup(place_m=(0.5, -0.15)), cup("blue cup", "blue", (0.5, 0.15)))
    world = stage.toolbox.world
    stage.play(stage.pick(CUP))
    assert set(world.sightings) >= {"red cup", "blue cup"}
    stage.fake.world.hidden.add("blue cup")
    stage.fake.world.hidden.add("red cup")

    tree = stage.pick(CUP)
    tree.tick()

    assert world.sightings == {}


@pytest.mark.requirement("P2")
@pytest.mark.parametrize(("twins", "look"), [(False, "look closer"), (True, "look before asking")])
def test_what_is_seen_unsurely_is_looked_at_closer_and_then_gone_for(stage_with, twins, look):
    stage = stage_with(table(), cup(), looks_for_twins=twins)
    stage.fake.detector.confidence["red cup"] = 0.3
    stage.when(look, stage.fake.detector.confidence.clear)

    tree = stage.play(stage.pick())

    assert tree.status == "success"


@pytest.mark.requirement("P2")
def test_whether_it_is_the_thing_is_asked_when_no_look_has_told(stage):
    stage.fake.detector.confidence["red cup"] = 0.3

    tree = stage.play(stage.pick())

    assert tree.failure.root.message == "is this the red cup?"
    assert tree.failure.choice_names == ("red cup",)
    (pictured,) = [event for event in stage.events if isinstance(event, ThingPictured)]
    assert (pictured.what, base64.b64decode(pictured.png_base64)) == ("red cup", PICTURE)
    assert not any(isinstance(request, PickRequest) for request in stage.fake.planning.requests)


@pytest.mark.requirement("P2")
def test_what_a_person_has_said_it_is_is_gone_for_however_unsurely_it_is_seen(stage):
    stage.fake.detector.confidence["red cup"] = 0.3

    tree = stage.play(stage.pick(PickTask("pick it up", exactly("red cup"))))

    assert tree.status == "success"


@pytest.mark.requirement("F3")
@pytest.mark.parametrize("there", [True, False])
def test_what_no_look_shows_is_looked_for_where_it_was_seen_before(stage_with, quick, there):
    away = Gaze("away", tilt_rad=0.6, pan_rad=-0.9)
    policy = replace(quick, search_gazes=(away,), survey_gazes=(away, away), last_gaze=away)
    red = cup(place_m=(0.45, 0.45))
    stage = stage_with(table(), red, policy=policy)
    believe(stage, [table(), red])
    if not there:
        stage.fake.world.hidden.add("red cup")

    found = stage.run(search("search", stage.toolbox), task=CUP)

    assert found is (Status.SUCCESS if there else Status.FAILURE)
    assert ("red cup" in stage.told.scene.objects) is there
