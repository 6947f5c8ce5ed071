"""When a question is put: not before arms that may hide what has gone are out of the way."""

import pytest

from robots.fake.fake_world import cup, table
from trees.failures import Failure, OpenChoice
from trees.skills.looking.search import looking_from_home_is_useless
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
