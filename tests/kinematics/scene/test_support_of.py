import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.scene.planning_scene import PlanningScene, SceneObject, floor
from kinematics.scene.support_of import support_of, supports_of, under_foot_of


def test_a_cup_on_a_table_is_supported_by_it_and_one_beside_it_is_not(make):
    scene = PlanningScene().with_objects([make.table(), make.cup()])

    assert supports_of(make.cup(), scene) == ["table"]
    assert supports_of(make.cup(x=0.1), scene) == []


@pytest.mark.parametrize(("x", "stands"), [(0.0, True), (0.39, True), (0.45, False)])
def test_a_round_table_carries_what_is_over_its_disc(x, stands):
    table = SceneObject("table", Cylinder(0.4, 0.7), poses.translation(0.0, 0.0, 0.35), movable=False)
    cup = SceneObject("cup", Cylinder(0.03, 0.1), poses.translation(x, 0.0, 0.75))

    assert supports_of(cup, PlanningScene().with_objects([table, cup])) == (["table"] if stands else [])


def test_a_lying_cylinder_is_carried_by_what_its_side_lies_on(make):
    table = SceneObject("table", Box((1.0, 1.0, 0.1)), poses.translation(0.0, 0.0, 0.65), movable=False)
    pose = poses.transform(poses.rotation_x(1.5707963), (0.0, 0.0, 0.73))
    can = SceneObject("can", Cylinder(0.03, 0.2), pose)

    assert support_of(can, PlanningScene().with_objects([table, can]), 0.01).name == "table"


def test_what_may_be_grasped_carries_what_is_over_it_and_furniture_carries_both(make):
    box = SceneObject("box", Box((0.2, 0.2, 0.1)), poses.translation(0.0, 0.0, 0.05))
    cup = SceneObject("cup", Cylinder(0.03, 0.1), poses.translation(0.0, 0.0, 0.15))

    on_box = PlanningScene().with_objects([box, cup])
    beside = SceneObject("can", Cylinder(0.03, 0.1), poses.translation(0.11, 0.0, 0.15))

    assert supports_of(cup, on_box) == ["box"]
    assert supports_of(beside, on_box) == []
    assert support_of(cup, on_box, 0.01) is None
    assert support_of(cup, on_box.with_object(floor()), 0.01).name == "floor"


@pytest.mark.parametrize(("y", "walls"), [(0.0, []), (0.16, ["wall"]), (-0.16, [])])
def test_a_foot_over_the_wall_of_a_chest_is_on_its_top_and_on_the_wall(y, walls):
    top = SceneObject("top", Box((0.5, 0.4, 0.02)), poses.translation(0.0, 0.0, 1.07), movable=False)
    wall = SceneObject("wall", Box((0.5, 0.02, 0.22)), poses.translation(0.0, 0.21, 0.97), movable=False)
    cup = SceneObject("cup", Cylinder(0.033, 0.13), poses.translation(0.0, y, 1.145))

    found = under_foot_of(cup, PlanningScene().with_objects([top, wall, cup]))

    assert [name for name in found if name == "wall"] == walls
