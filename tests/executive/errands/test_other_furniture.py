"""Who has walked to the other table stands before it, and it is still the other one."""

import numpy as np
import pytest

from executive.errands.nearness import Nearness, is_near
from executive.errands.other_furniture import named_other, with_other_furniture_named
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from trees.beliefs.scene.believed_thing import surroundings
from trees.tasks import (
    CountTask,
    FindTask,
    LookAtTask,
    ObjectDescription,
    PickTask,
    PlaceTask,
    Relation,
    WalkToTask,
)

GAP_M = 0.02
OTHER = ObjectDescription("table", ordinal="other")
HERE, THERE = np.eye(4), poses.transform(poses.rotation_z(np.pi), (2.4, 0.0, 0.0))
SCENE = PlanningScene().with_objects(
    SceneObject(name, Box((0.6, 0.8, 0.04)), poses.translation(x, 0.0, 0.8), movable=False)
    for name, x in (("table", 0.7), ("table 2", 1.75))
)


def around(odom_T_base, asked_at):
    return surroundings(SCENE, odom_T_base, GAP_M, None, asked_at)


@pytest.mark.parametrize("odom_T_base", [HERE, THERE])
@pytest.mark.parametrize(("asked_at", "name"), [(HERE, "table 2"), (THERE, "table")])
def test_it_is_told_from_where_the_robot_was_asked(odom_T_base, asked_at, name):
    walk = with_other_furniture_named(
        WalkToTask("walk to the other table", OTHER), around(odom_T_base, asked_at), None
    )

    assert walk.to.name == name


def test_what_is_moved_goes_to_another_table_than_its_own():
    place = with_other_furniture_named(
        PlaceTask("", ObjectDescription("cup"), on=OTHER), around(HERE, HERE), "table 2"
    )

    assert place.on.name == "table"


def test_what_is_no_other_furniture_stays_as_it_was_said():
    pick = PickTask("", ObjectDescription("cup", ordinal="other"))

    assert with_other_furniture_named(pick, around(HERE, HERE), None) is pick


def test_the_other_table_is_near_only_where_the_robot_stands_before_it():
    wanted = Nearness(named_other(OTHER, around(HERE, HERE)))

    assert not is_near(wanted, around(HERE, HERE), SCENE, HERE)
    assert is_near(wanted, around(THERE, HERE), SCENE, THERE)


@pytest.mark.parametrize(
    "command",
    [
        PickTask("", ObjectDescription("cup"), OTHER),
        PlaceTask("", ObjectDescription("cup"), to=ObjectDescription("shelf"), source=OTHER),
        FindTask("", ObjectDescription("cup"), source=OTHER),
        CountTask("", ObjectDescription("cup"), source=OTHER),
    ],
)
def test_where_something_is_said_to_be_is_told_from_where_the_robot_was_asked(command):
    assert with_other_furniture_named(command, around(THERE, HERE), None).source.name == "table 2"


def test_what_is_moved_is_taken_from_the_other_table_though_it_stands_there():
    place = PlaceTask("", ObjectDescription("cup"), to=ObjectDescription("shelf"), source=OTHER)

    assert with_other_furniture_named(place, around(THERE, HERE), "table 2").source.name == "table 2"


@pytest.mark.parametrize(
    ("command", "slot"),
    [
        (LookAtTask("", ObjectDescription("cup", relation=Relation("on", OTHER))), "object"),
        (WalkToTask("", ObjectDescription("cup", relation=Relation("on", OTHER))), "to"),
    ],
)
def test_what_is_on_the_other_table_is_on_the_one_that_was_meant(command, slot):
    named = getattr(with_other_furniture_named(command, around(THERE, HERE), None), slot)

    assert named.relation.to.name == "table 2"
