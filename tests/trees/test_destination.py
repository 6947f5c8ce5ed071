"""Who is meant, from where the robot stands and faces."""

import math

import numpy as np
import pytest

from kinematics import poses
from kinematics.scene import PlanningScene, SceneObject
from kinematics.shapes import Cylinder
from robots.perception.object_estimate import ObjectEstimate
from trees.believed_thing import surroundings
from trees.destination import called, resolve
from trees.tasks import ObjectDescription

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
