"""Who is meant, from where the robot stands and faces."""

import math

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.grounding.destination import Place, called, resolve
from trees.beliefs.scene.believed_thing import surroundings
from trees.tasks import ObjectDescription, Relation

BODY = Cylinder(0.24, 1.75)
PEOPLE = {"Ana": (1.5, 0.0), "Ben": (0.0, 4.0)}


def look(base):
    seen = {
        name: ObjectEstimate("person", "person", None, poses.translation(*at, 0.9), BODY, 0.9, 8, 0.0)
        for name, at in PEOPLE.items()
    }
    scene = PlanningScene().with_objects(
        SceneObject(name, BODY, item.odom_T_object, movable=False) for name, item in seen.items()
    )
    return seen, surroundings(scene, base, 0.05)


@pytest.mark.parametrize(("word", "yaw", "who"), [("in_front", 0.0, "Ana"), ("in_front", math.pi / 2, "Ben")])
def test_in_front_is_where_the_robot_faces_now(word, yaw, who):
    seen, around = look(poses.transform(poses.rotation_z(yaw), (0.0, 0.0, 1.0)))

    assert resolve(word, seen, around).name == who


@pytest.mark.parametrize(("at", "who"), [((0.0, 0.0), "Ana"), ((0.0, 3.0), "Ben")])
def test_me_is_who_is_nearest_to_where_the_robot_stands_now(at, who):
    seen, around = look(poses.transform(np.eye(3), (*at, 1.0)))

    assert resolve("me", seen, around).name == who


@pytest.mark.parametrize(
    ("wanted", "words"),
    [
        ("kitchen", "the kitchen"),
        ("Ana", "Ana"),
        ("me", "the person"),
        (ObjectDescription("cup", "red"), "the red cup"),
    ],
)
def test_what_is_aimed_at_has_an_article_unless_it_has_a_name(wanted, words):
    assert called(wanted) == words


AHEAD = np.eye(4)
"""Ana stands ahead, Ben to the left."""


def person(ordinal=None, relation=None, kind="person"):
    return ObjectDescription(kind, ordinal=ordinal, relation=relation)


@pytest.mark.requirement("L3")
@pytest.mark.parametrize(
    ("wanted", "who"),
    [
        (person("leftmost"), "Ben"),
        (person("rightmost"), "Ana"),
        (person(relation=Relation("nearest", "robot")), "Ana"),
        (person(relation=Relation("next_to", "table")), "Ben"),
    ],
)
def test_one_of_several_people_is_meant_by_order_or_place(wanted, who):
    seen, _ = look(AHEAD)
    table = SceneObject("table", Box((0.6, 0.8, 0.04)), poses.translation(0.9, 4.0, 0.8), movable=False)
    people = [SceneObject(name, BODY, item.odom_T_object, movable=False) for name, item in seen.items()]
    around = surroundings(PlanningScene().with_objects([*people, table]), AHEAD, 0.05)

    assert resolve(wanted, seen, around, "person", somebody=True).name == who


@pytest.mark.requirement("L3")
@pytest.mark.parametrize("wanted", [person(kind="guest"), person("leftmost", kind="man")])
def test_what_cannot_be_seen_of_people_is_asked(wanted):
    seen, around = look(AHEAD)

    failure = resolve(wanted, seen, around, "person", somebody=True)

    assert failure.choices == failure.choice_names == ("Ben", "Ana")
    assert failure.choice_slot == "person"
    assert f"which one is the {wanted}" in failure.message


def test_somebody_who_was_seen_before_is_meant_as_well():
    seen, around = look(AHEAD)
    ben = Place("Ben", "person", BODY, seen["Ben"].odom_T_object, 0.5)

    found = resolve(person("leftmost"), {"Ana": seen["Ana"]}, around, recalled={"Ben": ben})

    assert found == ben


@pytest.mark.requirement("F1")
@pytest.mark.parametrize(
    ("kind", "is_there"), [("person", True), (None, True), ("Ana", True), ("cup", False)]
)
def test_what_has_the_name_and_is_of_another_kind_is_not_taken_for_it(kind, is_there):
    seen, around = look(AHEAD)

    resolved = resolve(ObjectDescription(kind, name="Ana"), seen, around)

    assert isinstance(resolved, Place) is is_there
