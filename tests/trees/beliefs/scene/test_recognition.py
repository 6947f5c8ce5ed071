from dataclasses import replace

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.scene.recognition import nearest_sighting
from trees.port_values import Target

CUP = Cylinder(0.03, 0.11)
PLACE = (0.5, 0.0, 0.95)
TARGET = Target("red cup", "cup", "red", CUP, poses.translation(*PLACE), 0.9)


def sighting(*at, kind="cup", color="red"):
    return ObjectEstimate("object", kind, color, poses.translation(*at), CUP, 0.9, 8, 0.003)


def find(*estimates, scene=None):
    return nearest_sighting(TARGET, np.array(PLACE), estimates, scene or PlanningScene(), 0.05)


def test_the_nearest_of_its_kind_and_colour_is_it():
    far, near = sighting(0.6, 0.0, 0.95), sighting(0.52, 0.0, 0.95)

    found, distance = find(far, near)

    assert found is near
    assert abs(distance - 0.02) < 1e-9


def test_another_kind_or_colour_is_not_it():
    assert find(sighting(*PLACE, kind="can"), sighting(*PLACE, color="blue")) is None


@pytest.mark.requirement("P2")
def test_what_looks_like_another_kind_and_may_be_its_is_it():
    assert find(replace(sighting(*PLACE, kind="can"), alike=("cup",))) is not None


def test_a_colour_that_could_not_be_told_may_be_it():
    assert find(sighting(*PLACE, color=None)) is not None


def test_a_twin_that_is_known_to_stand_elsewhere_is_not_it():
    twin = SceneObject("red cup 2", CUP, poses.translation(0.5, 0.3, 0.95))
    scene = PlanningScene().with_object(twin)

    assert find(sighting(0.5, 0.3, 0.95), scene=scene) is None


@pytest.mark.requirement("P2")
@pytest.mark.parametrize("shape", [CUP, Box((0.05, 0.06, 0.11))])
def test_what_hangs_with_its_foot_behind_something_is_where_its_top_is(shape):
    """It seems to stand on the table, and to reach down there."""
    target = replace(TARGET, shape=shape)
    down_to_the_table = Box((0.05, 0.06, 0.24)) if isinstance(shape, Box) else Cylinder(0.03, 0.24)
    seen = replace(sighting(0.5, 0.0, 0.895 + 0.12), shape=down_to_the_table)
    in_the_hand = np.array([0.5, 0.0, 1.08])

    found, away_m = nearest_sighting(target, in_the_hand, [seen], PlanningScene(), 0.05)

    assert found.odom_T_object[2, 3] == pytest.approx(0.895 + 0.24 - 0.055)
    assert found.shape.height_m == pytest.approx(0.11)
    assert away_m == pytest.approx(0.0, abs=1e-9)


@pytest.mark.requirement("P2")
@pytest.mark.parametrize(
    ("seen_z_m", "expected_z_m", "told_z_m"),
    [(1.10, 1.08, 1.08), (1.06, 1.08, 1.08), (1.10, 1.02, 1.07), (1.03, 1.10, 1.06)],
    ids=["its upper part", "its lower part", "too high", "too low"],
)
def test_of_what_fingers_hide_a_part_is_where_it_is_expected_as_far_as_that_fits(
    seen_z_m, expected_z_m, told_z_m
):
    seen = replace(sighting(0.5, 0.0, seen_z_m), shape=Cylinder(0.03, 0.05))

    found, away_m = nearest_sighting(
        TARGET, np.array([0.5, 0.0, expected_z_m]), [seen], PlanningScene(), 0.05
    )

    assert found.odom_T_object[2, 3] == pytest.approx(told_z_m)
    assert found.shape == CUP
    assert away_m == pytest.approx(abs(told_z_m - expected_z_m), abs=1e-9)


def test_what_is_about_as_high_as_it_was_is_where_it_is_seen():
    seen = replace(sighting(0.5, 0.0, 0.96), shape=Cylinder(0.03, 0.12))

    found, _ = find(seen)

    assert found is seen
