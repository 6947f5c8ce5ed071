import numpy as np

from kinematics.geometry.shapes import Box
from kinematics.scene.namespace import reserved_names, with_names_of_their_own
from kinematics.scene.planning_scene import FLOOR, PlanningScene, SceneObject


def scene_of(*names):
    pose = np.eye(4)
    return PlanningScene().with_objects(SceneObject(name, Box((0.1, 0.1, 0.1)), pose) for name in names)


def test_links_joints_and_the_floor_are_reserved(talos):
    assert {FLOOR, "arm_left_7_link", "arm_left_7_joint", "base_link", "universe"} <= reserved_names(talos)


def test_what_is_called_as_a_link_or_the_floor_gets_a_name_of_its_own(talos):
    names = ("red cup", "floor", "floor (object)", "arm_left_7_link")

    own = with_names_of_their_own(scene_of(*names), talos)

    assert list(own.objects) == [
        "red cup", "floor (object) (object)", "floor (object)", "arm_left_7_link (object)",
    ]  # fmt: skip
    assert all(item.name == name for name, item in own.objects.items())


def test_a_scene_with_ordinary_names_is_left_as_it_is(talos):
    scene = scene_of("red cup", "table/top")

    assert with_names_of_their_own(scene, talos) is scene
