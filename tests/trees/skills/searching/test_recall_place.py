"""What stays where it is can be walked to out of sight, and what the robot put down; other things cannot."""

from dataclasses import replace

import pytest
from py_trees.common import Status

from kinematics.geometry.poses import translation
from kinematics.scene.label import Label
from kinematics.scene.planning_scene import SceneObject
from robots.fake.fake_world import cup, person, table
from trees.skills.searching.recall_place import RecallPlace
from trees.tasks import ObjectDescription, WalkToTask


@pytest.fixture
def recall(stage):
    """Runs the leaf in a world with a table, a cup and Ana, all of them out of view."""
    solids = [
        SceneObject(one.name, one.shape, one.world_T_object, 0.0, movable=one.category == "object")
        for one in (table(), cup(), person())
    ]
    stage.told.update(stage.told.scene.with_objects(solids))

    def run(to, **settings):
        leaf = RecallPlace("recall it", stage.toolbox, **settings)
        status = stage.run(leaf, task=WalkToTask("walk there", to))
        return stage.output("place") if status is Status.SUCCESS else None

    return run


@pytest.mark.parametrize(
    ("to", "category"),
    [("Ana", "person"), ("table", "furniture"), (ObjectDescription("table"), "furniture")],
)
def test_people_and_furniture_are_recalled(recall, to, category):
    assert recall(to).category == category


def test_furniture_is_recalled_by_what_it_is_called_besides(stage, recall):
    known = stage.told.scene.objects
    named = replace(known["table"], label=Label("table", names=("table", "workbench")))
    stage.told.update(stage.told.scene.with_objects([*known.values(), named]))

    assert recall(ObjectDescription("workbench")).name == "table"
    assert recall(ObjectDescription("desk")) is None


def test_an_object_is_not_recalled(recall):
    assert recall(ObjectDescription("cup", "red")) is None
    assert recall("red cup") is None


@pytest.mark.parametrize("to", [ObjectDescription("cup", "red"), "red cup"])
def test_as_the_last_resort_any_object_is_recalled(recall, to):
    assert recall(to, anything=True).name == "red cup"
    assert recall(ObjectDescription("can"), anything=True) is None


@pytest.mark.parametrize("to", [ObjectDescription("cup", "red"), ObjectDescription("cup"), "red cup"])
def test_what_the_robot_put_down_itself_is_recalled(stage, recall, to):
    stage.told.note_put_down("red cup")

    place = recall(to)

    assert (place.name, place.category) == ("red cup", "object")


def test_what_was_put_down_is_recalled_where_a_later_look_has_shown_it(stage, recall):
    stage.told.note_put_down("red cup")
    moved = SceneObject("red cup", cup().shape, translation(0.5, 0.25, 0.955))
    stage.told.update(stage.told.scene.with_object(moved))

    assert recall(ObjectDescription("cup", "red")).odom_T_place == pytest.approx(moved.world_T_object)


def test_what_was_put_down_and_then_missed_by_a_look_is_recalled_where_it_was_let_go_of(stage, recall):
    stage.told.note_put_down("red cup")
    stage.told.update(stage.told.scene.without_object("red cup"))

    place = recall(ObjectDescription("cup", "red"))

    assert place.odom_T_place == pytest.approx(cup().world_T_object)


def test_what_was_put_down_and_taken_up_again_is_not_recalled(stage, recall):
    stage.told.note_put_down("red cup")
    stage.told.update(stage.told.scene.with_attached("red cup", "hand", translation(0.0, 0.0, 0.0), ()))

    assert recall(ObjectDescription("cup", "red")) is None


def test_of_two_things_that_fit_and_were_put_down_none_is_recalled(stage, recall):
    other = SceneObject("black cup", cup().shape, translation(0.5, 0.25, 0.955))
    stage.told.update(stage.told.scene.with_object(other))
    stage.told.note_put_down("red cup")
    stage.told.note_put_down("black cup")

    assert recall(ObjectDescription("cup")) is None
    assert recall(ObjectDescription("cup", "black")).name == "black cup"


def test_what_was_never_seen_is_not_recalled(recall):
    assert recall("Ben") is None
