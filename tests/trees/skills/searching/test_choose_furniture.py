"""Furniture to look at from nearby: the nearest top first, none twice, none that nothing stands on."""

from py_trees.common import Status

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.scene.planning_scene import SceneObject
from trees.skills.searching.choose_furniture import ChooseFurniture
from trees.tasks import ObjectDescription, WalkToTask

CUP = WalkToTask("walk to the cup", ObjectDescription("cup"))


def board(name, x, size=(0.6, 1.0, 0.04), top=0.8):
    return SceneObject(name, Box(size), poses.translation(x, 0.0, top - 0.5 * size[2]), movable=False)


def know(stage, *things):
    stage.told.update(stage.told.scene.with_objects(things))


def test_the_nearest_top_comes_first_and_none_twice(stage):
    know(stage, board("counter", 5.0), board("table", 3.0), board("table 2", 3.3, size=(0.05, 0.05, 0.7)))
    leaf = ChooseFurniture("choose", stage.toolbox, {"visited_before": "visited"})

    assert stage.run(leaf, task=CUP) is Status.SUCCESS
    assert stage.output("furniture").name == "table"
    assert stage.run(leaf) is Status.SUCCESS
    assert stage.output("furniture").name == "counter"
    assert stage.run(leaf) is Status.FAILURE
    assert "no furniture is left" in stage.failed()[-1].message


def test_what_nothing_stands_on_is_not_looked_at(stage):
    wall, fridge = board("wall", 3.0, (0.1, 4.0, 2.5), 2.5), board("fridge", 3.0, (0.6, 0.6, 0.1), 1.0)
    know(stage, wall, fridge, board("table", 0.7))  # and the table is where the robot stands

    assert stage.run(ChooseFurniture("choose", stage.toolbox), task=CUP) is Status.FAILURE


def test_people_are_not_looked_for_on_tables(stage):
    know(stage, board("table", 3.0))

    assert (
        stage.run(ChooseFurniture("choose", stage.toolbox), task=WalkToTask("walk to Ana", "Ana"))
        is Status.FAILURE
    )


def test_who_was_before_one_board_of_a_shelf_has_been_before_the_others(stage):
    know(stage, board("shelf", 3.0), board("shelf 2", 3.0, top=1.2), board("table", 6.0))
    leaf = ChooseFurniture("choose", stage.toolbox, {"visited_before": "visited"})

    assert stage.run(leaf, task=CUP) is Status.SUCCESS
    assert stage.run(leaf) is Status.SUCCESS
    assert stage.output("furniture").name == "table"


def test_a_top_that_the_robot_stands_beside_but_does_not_face_was_not_looked_at(stage):
    behind = SceneObject("table", Box((0.6, 1.0, 0.04)), poses.translation(-0.7, 0.0, 0.78), movable=False)
    know(stage, behind)

    assert stage.run(ChooseFurniture("choose", stage.toolbox), task=CUP) is Status.SUCCESS
    assert stage.output("furniture").name == "table"
