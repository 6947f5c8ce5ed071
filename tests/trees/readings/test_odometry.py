"""Whoever asks what is around the robot is told the same."""

import math

import pytest
from py_trees.common import Status

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.scene.planning_scene import SceneObject
from robots.fake.fake_world import cup, table
from robots.perception.truth_view import TrueObject
from trees.beliefs.grounding.grounding import Ambiguous, Found, ground
from trees.beliefs.scene.believed_thing import surroundings
from trees.build import build_tree
from trees.policy import Gaze
from trees.readings.odometry import base_pose, what_is_around
from trees.skills.looking.detect import Detect
from trees.skills.looking.look_at import LookAt
from trees.skills.telling.tell import TellCount
from trees.tasks import CountTask, ObjectDescription, PickTask, Relation, WalkToTask

OTHER = ObjectDescription("table", ordinal="other")
LEFT = TrueObject(
    "table 2", "furniture", "table", None, Box((0.6, 0.8, 0.04)), poses.translation(0.3, 2.0, 0.88)
)
BEFORE_THE_LEFT_ONE = poses.transform(poses.rotation_z(0.5 * math.pi), (0.3, 1.3, 1.0))
"""A pose of the base: the table that the fake robot stands before is the other one from there."""


@pytest.fixture
def arrived(stage_with):
    """Who was asked before the left table has come to this one, and sees the cup on it."""
    stage = stage_with(table(), cup(), LEFT)
    left = SceneObject("table 2", LEFT.shape, LEFT.world_T_object, movable=False)
    stage.told.update(stage.told.scene.with_object(left))
    stage.told.asked_at = BEFORE_THE_LEFT_ONE
    stage.run(LookAt("look", stage.toolbox, Gaze("ahead", 0.75)))
    return stage


def test_a_look_finds_the_cup_on_the_other_table_than_the_one_that_was_left(arrived):
    task = PickTask("pick up the cup from the other table", ObjectDescription("cup"), OTHER)

    assert arrived.run(Detect("detect", arrived.toolbox), task=task) is Status.SUCCESS


def test_the_cups_on_the_other_table_than_the_one_that_was_left_are_counted(arrived):
    arrived.run(Detect("detect", arrived.toolbox), task=PickTask("", ObjectDescription("cup")))
    leaf = TellCount("tell", arrived.toolbox)

    assert arrived.run(leaf, task=CountTask("", ObjectDescription("cup"), OTHER)) is Status.SUCCESS
    assert leaf.feedback_message == "there is one cup"


def test_it_is_told_from_the_pose_of_the_base(arrived):
    assert what_is_around(arrived.toolbox).here_T_asked == pytest.approx(
        surroundings(
            arrived.told.scene, base_pose(arrived.toolbox), 0.05, None, BEFORE_THE_LEFT_ONE
        ).here_T_asked
    )


# --- who was sent to a table means what is there -------------------------------------------------

CUPS = [
    SceneObject(name, Cylinder(0.03, 0.11), poses.translation(0.45, y, 0.955))
    for name, y in (("red cup", -0.2), ("red cup 2", 1.9))
]
TABLES = [SceneObject(item.name, item.shape, item.world_T_object, movable=False) for item in (table(), LEFT)]


@pytest.fixture
def two_tables(stage):
    """A cup on each of two tables."""
    stage.told.update(stage.told.scene.with_objects([*TABLES, *CUPS]))
    return stage


@pytest.mark.parametrize(("sent_to", "name"), [("table", "red cup"), ("table 2", "red cup 2")])
@pytest.mark.parametrize("ordinal", [None, "leftmost", "nearest"])
def test_the_cup_is_the_one_on_the_table_that_was_walked_to(two_tables, sent_to, name, ordinal):
    two_tables.told.sent_to = sent_to

    answer = ground(ObjectDescription("cup", ordinal=ordinal), what_is_around(two_tables.toolbox))

    assert answer == Found((name,))


def test_which_cup_is_asked_where_nobody_was_sent_anywhere(two_tables):
    assert isinstance(ground(ObjectDescription("cup"), what_is_around(two_tables.toolbox)), Ambiguous)


def test_a_cup_that_is_said_to_be_on_another_table_is_not_looked_for_where_the_robot_was_sent(two_tables):
    two_tables.told.sent_to = "table 2"
    on_the_right = ObjectDescription(
        "cup", relation=Relation("on", ObjectDescription("table", ordinal="rightmost"))
    )

    assert ground(on_the_right, what_is_around(two_tables.toolbox)) == Found(("red cup",))


def test_what_is_not_where_the_robot_was_sent_is_meant_where_it_is(two_tables):
    two_tables.told.update(two_tables.told.scene.without_object("red cup 2"))
    two_tables.told.sent_to = "table 2"

    assert ground(ObjectDescription("cup"), what_is_around(two_tables.toolbox)) == Found(("red cup",))


def test_what_is_on_the_other_table_is_not_told_from_afar(stage_with):
    far = TrueObject("table 2", "furniture", "table", None, LEFT.shape, poses.translation(0.3, 3.0, 0.88))
    stage = stage_with(table(), far, walks=True)
    stage.told.update(
        stage.told.scene.with_objects(
            [*TABLES[:1], SceneObject("table 2", far.shape, far.world_T_object, movable=False)]
        )
    )
    leaf = TellCount("tell", stage.toolbox)

    assert stage.run(leaf, task=CountTask("", ObjectDescription("cup"), OTHER)) is Status.FAILURE
    assert leaf.failure.message == "the other table is too far away to see all that is on it"


def test_who_has_walked_to_a_table_was_sent_there_until_it_walks_on(stage_with):
    stage = stage_with(table(), cup(), walks=True)

    walk = stage.play(build_tree(WalkToTask("walk to the table", "table"), stage.toolbox))
    sent_to = stage.told.sent_to
    stage.play(build_tree(WalkToTask("walk to the cup", ObjectDescription("cup")), stage.toolbox))

    assert (walk.status, sent_to, stage.told.sent_to) == ("success", "table", None)
