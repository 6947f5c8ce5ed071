import numpy as np
import pytest

from kinematics.errors import UnknownNameError
from kinematics.scene.planning_scene import PlanningScene


def test_every_change_makes_a_newer_scene_and_leaves_the_old_one(make):
    first = PlanningScene()
    second = first.with_object(make.cup())
    third = second.without_object("cup")

    assert [s.version for s in (first, second, third)] == [0, 1, 2]
    assert list(second.objects) == ["cup"]
    assert not first.objects
    assert not third.objects


def test_attach_and_detach_move_the_object_between_hand_and_world(make):
    scene = PlanningScene().with_object(make.cup())

    held = scene.with_attached("cup", "tcp_left", np.eye(4), ["finger"])
    put = held.with_detached("cup", make.cup(x=0.7).world_T_object)

    assert not held.objects
    assert held.attached["cup"].touch_links == {"finger"}
    assert not put.attached
    assert put.objects["cup"].world_T_object[0, 3] == 0.7


def test_an_unknown_object_is_named_with_the_nearest(make):
    scene = PlanningScene().with_object(make.cup())

    with pytest.raises(UnknownNameError, match="no object 'cap' among 1; did you mean 'cup'"):
        scene.without_object("cap")


def test_allowed_pairs_have_no_order():
    scene = PlanningScene().allowing([("a", "b")])

    assert scene.is_allowed("b", "a")
    assert not scene.is_allowed("a", "c")


def test_who_gave_a_scene_its_objects_cannot_change_them(make):
    own = {"cup": make.cup()}
    scene = PlanningScene(objects=own)

    own.clear()

    assert list(scene.objects) == ["cup"]
    with pytest.raises(TypeError):
        scene.objects["cup"] = make.cup(x=0.9)
