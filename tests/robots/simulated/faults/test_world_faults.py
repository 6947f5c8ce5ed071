"""Things that go wrong on purpose go wrong as they are called."""

from dataclasses import replace

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Cylinder
from robots.scenes.scene_description import SceneItem
from robots.scenes.scene_file import load_scene

CUP = "red cup"


@pytest.fixture
def body(stand):
    body = stand(load_scene("tabletop"))
    body.run(0.1)
    return body


def test_a_removed_object_is_gone_from_sight_and_from_the_table(body):
    body.world.faults.remove(CUP)
    body.run(0.1)

    assert CUP not in body.truth.objects()
    assert CUP not in [solid.name for solid in body.truth.solids()]
    assert body.truth.contacts.of_object(CUP) == ("floor",)


def test_what_was_removed_can_come_back(body):
    place = body.truth.world_T_object(CUP)
    body.world.faults.remove(CUP)

    body.world.faults.teleport(CUP, place)

    assert CUP in body.truth.objects()
    assert body.truth.world_T_object(CUP) == pytest.approx(place)


def test_a_displaced_object_stands_a_step_away(body):
    before = body.truth.world_T_object(CUP)[:3, 3]

    body.world.faults.displace(CUP, (0.03, -0.05))
    body.run(0.3)

    assert body.truth.world_T_object(CUP)[:3, 3] - before == pytest.approx((0.03, -0.05, 0.0), abs=0.001)
    assert body.truth.tilt_rad(CUP) < 0.001


@pytest.mark.parametrize("direction_rad", [0.0, 1.0, 2.5, -2.0])
@pytest.mark.parametrize("distance_m", [0.03, 0.08])
def test_a_knocked_cup_slides_that_way_and_stays_standing(body, direction_rad, distance_m):
    before = body.truth.world_T_object(CUP)[:2, 3].copy()

    body.world.faults.knock(CUP, direction_rad, distance_m)
    body.run(1.0)
    moved = body.truth.world_T_object(CUP)[:2, 3] - before

    assert body.truth.tilt_rad(CUP) < 0.01
    assert 0.5 * distance_m < np.linalg.norm(moved) < 1.5 * distance_m
    assert moved / np.linalg.norm(moved) == pytest.approx(
        (np.cos(direction_rad), np.sin(direction_rad)), abs=0.1
    )


@pytest.mark.parametrize("direction_rad", [0.0, 1.5, -1.5, 3.0])
def test_a_cup_that_is_tipped_over_lies(body, direction_rad):
    body.world.faults.tip_over(CUP, direction_rad)
    body.run(1.0)

    assert body.truth.tilt_rad(CUP) > 1.2


def test_faults_wait_for_their_time(body):
    body.world.faults.at(0.5, lambda: body.world.faults.remove(CUP))

    body.run(0.39)
    assert CUP in body.truth.objects()
    body.run(0.02)
    assert CUP not in body.truth.objects()


def test_faults_wait_for_their_condition_and_happen_once(body):
    happened = []
    body.world.faults.when(lambda: body.truth.time_s > 0.2, lambda: happened.append(body.truth.time_s))

    body.run(0.3)

    assert happened == [pytest.approx(0.202, abs=0.0021)]


@pytest.mark.parametrize(("radius_m", "height_m", "mass_kg"), [(0.02, 0.16, 0.1), (0.038, 0.08, 0.6)])
def test_slender_and_squat_cups_stay_standing_when_knocked_too(stand, radius_m, height_m, mass_kg):
    scene = load_scene("tabletop")
    pose = poses.translation(0.5, -0.2, 0.9 + 0.5 * height_m)
    cup = SceneItem("cup", "cup", "red", Cylinder(radius_m, height_m), mass_kg, 0.6, pose)
    body = stand(replace(scene, objects=(cup,)))

    body.world.faults.knock("cup", 0.5, 0.06)
    body.run(1.5)

    assert body.truth.tilt_rad("cup") < 0.01
    assert np.linalg.norm(body.truth.world_T_object("cup")[:2, 3] - (0.5, -0.2)) == pytest.approx(
        0.06, abs=0.003
    )


def test_an_unknown_object_is_an_error(body):
    with pytest.raises(KeyError):
        body.world.faults.remove("green elephant")
