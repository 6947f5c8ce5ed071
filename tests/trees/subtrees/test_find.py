"""What is not to be seen from here is looked for from elsewhere, by a robot that walks."""

import dataclasses

import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from robots.fake.fake_world import cup, person, table
from robots.perception.truth_view import TrueObject
from robots.scenes.scene_description import Region
from trees.build import build_tree
from trees.events import Said
from trees.tasks import FindTask, ObjectDescription

ANA = person("Ana", (-1.5, 0.3))
FIND_ANA = FindTask("find Ana", person="Ana")
FIND_CUP = FindTask("where is the white cup?", ObjectDescription("cup", "white"))
FAR_TABLE = TrueObject(
    "table 2", "furniture", "table", "unknown", Box((0.6, 1.0, 0.04)), poses.translation(-4.0, 0.0, 0.83)
)
ROOMS = {
    "living room": Region("living room", (-5.0, 0.0), (4.0, 4.0)),
    "kitchen": Region("kitchen", (1.0, 0.0), (4.0, 4.0)),
}
CUP_ON_FLOOR = cup("white cup", "white", (-5.0, 0.4), 0.0)
CUP_ON_IT = cup("white cup", "white", (-3.85, 0.1))


def said(stage):
    return [event.text for event in stage.events if isinstance(event, Said)]


@pytest.mark.requirement("F3")
def test_who_is_not_seen_from_here_is_looked_for_by_turning_around(new_stage):
    stage = new_stage(FAR_TABLE, walks=True)
    stage.when("turn around", lambda: stage.fake.world.put(ANA))

    tree = stage.play(build_tree(FIND_ANA, stage.toolbox))

    assert tree.status == "success"
    assert tree.evidence["found"] == "Ana"


@pytest.mark.requirement("F3")
def test_a_thing_is_looked_for_from_before_furniture_that_was_seen(new_stage):
    stage = new_stage(FAR_TABLE, CUP_ON_IT, walks=True)
    stage.fake.world.hidden.add("white cup")
    stage.when("walk", stage.fake.world.hidden.clear)

    tree = stage.play(build_tree(FIND_CUP, stage.toolbox))

    assert tree.status == "success"
    assert tree.evidence["found"] == "white cup"


def test_a_robot_that_does_not_walk_tells_that_it_did_not_see_her(new_stage):
    stage = new_stage(table())

    tree = stage.play(build_tree(FIND_ANA, stage.toolbox))

    assert tree.failure.message == "could not find Ana: no Ana seen"


def test_who_is_nowhere_is_told_as_not_seen_and_not_as_one_of_the_ways_that_were_barred(new_stage):
    stage = new_stage(table(), walks=True)

    tree = stage.play(build_tree(FIND_ANA, stage.toolbox))

    assert tree.failure.message == "could not find Ana: no Ana seen"


def test_what_was_found_is_told_with_what_it_stands_on_and_the_room(new_stage):
    stage = new_stage(table(), cup("white cup", "white"), walks=True)
    toolbox = dataclasses.replace(stage.toolbox, places=ROOMS)

    stage.play(build_tree(FIND_CUP, toolbox))

    assert said(stage)[0].startswith("the white cup is on the table, in the kitchen, 0.")


def test_once_no_furniture_is_left_no_more_is_chosen(new_stage):
    stage = new_stage(table(), walks=True)

    stage.play(build_tree(FIND_ANA, stage.toolbox))

    asked = [event for event in stage.events if getattr(event, "where", "").endswith("choose furniture")]
    assert len({event.where for event in asked}) == 1


@pytest.mark.parametrize("task", [FIND_ANA, FIND_CUP])
def test_what_is_in_no_room_that_was_seen_is_looked_for_in_the_others_of_the_map(new_stage, task):
    stage = new_stage(walks=True)
    stage.when("walk", lambda: stage.fake.world.put(ANA))
    stage.when("walk", lambda: stage.fake.world.put(CUP_ON_FLOOR))

    tree = stage.play(build_tree(task, dataclasses.replace(stage.toolbox, places=ROOMS)))

    assert tree.status == "success"


def test_the_room_where_one_is_is_not_gone_to_and_each_other_once(new_stage):
    stage = new_stage(walks=True)

    tree = stage.play(build_tree(FIND_ANA, dataclasses.replace(stage.toolbox, places=ROOMS)))

    gone = [event for event in stage.events if getattr(event, "where", "").endswith("choose room")]
    assert [event.message for event in gone if event.status == "success"] == ["living room"]
    assert tree.failure.message == "could not find Ana: no Ana seen"


@pytest.mark.requirement("M2", "L6")
def test_what_is_on_another_table_is_not_what_is_looked_for(new_stage):
    cup_here = cup("red cup", "red")
    stage = new_stage(table(), cup_here)
    red = ObjectDescription("cup", "red")

    elsewhere = stage.play(build_tree(FindTask("find it on the shelf", red, source="shelf"), stage.toolbox))
    here = stage.play(build_tree(FindTask("find it on the table", red, source="table"), stage.toolbox))

    assert elsewhere.failure.root.message == "a red cup is seen, but not on the shelf"
    assert here.status == "success"
    assert len(said(stage)) == 1
