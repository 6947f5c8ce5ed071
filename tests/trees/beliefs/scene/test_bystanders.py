import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Cylinder
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from trees.beliefs.scene.bystanders import bystanders, disturbed

CUP = Cylinder(0.03, 0.1)


def scene(**places):
    return PlanningScene().with_objects(
        SceneObject(name, CUP, poses.translation(x, y, 0.95), 0.01, True) for name, (x, y) in places.items()
    )


def test_what_is_seen_where_it_stood_was_not_disturbed():
    stood = bystanders(scene(red=(0.5, 0.0), blue=(0.5, 0.2)))

    assert disturbed(stood, scene(red=(0.504, 0.0), blue=(0.5, 0.2)), 0.01) is None


@pytest.mark.requirement("M2")
def test_what_was_pushed_is_told_by_name_and_distance():
    stood = bystanders(scene(red=(0.5, 0.0), blue=(0.5, 0.2)))

    failure = disturbed(stood, scene(red=(0.5, 0.0), blue=(0.5, 0.22)), 0.01)

    assert "the blue was moved" in failure.message
    assert failure.numbers["moved_m"] == pytest.approx(0.02)


def test_what_should_have_been_seen_and_was_not_is_told():
    failure = disturbed(bystanders(scene(red=(0.5, 0.0))), scene(), 0.01)

    assert "no longer where it stood" in failure.message


def test_one_that_is_judged_elsewhere_is_left_out():
    stood = {"bowl": np.zeros(3)}

    assert disturbed(stood, scene(bowl=(0.5, 0.0)), 0.01, except_for="bowl") is None
