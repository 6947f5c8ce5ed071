import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.scene.support_of import top_m
from trees.skills.place.lower import lowered_supports

TABLE = SceneObject("table", Box((0.6, 1.2, 0.04)), poses.translation(0.6, 0.0, 0.88), 0.015, movable=False)
BOWL = SceneObject("bowl", Cylinder(0.1, 0.07), poses.translation(0.6, 0.0, 0.935), 0.01)


def tops(below_m, names=("table", "bowl")):
    scene = lowered_supports(PlanningScene().with_objects([TABLE, BOWL]), names, below_m)
    return {name: top_m(item) for name, item in scene.objects.items()}


def test_a_table_that_was_not_touched_is_no_higher_than_what_was_lowered_onto_it():
    assert tops(0.893)["table"] == pytest.approx(0.893)


def test_a_table_that_what_was_lowered_has_not_come_to_stays_where_it_was_seen():
    assert tops(0.91)["table"] == pytest.approx(0.90)


def test_a_bowl_and_furniture_that_carries_nothing_stay_where_they_were_seen():
    assert tops(0.893)["bowl"] == pytest.approx(0.97)
    assert tops(0.893, names=("bowl", "shelf"))["table"] == pytest.approx(0.90)
