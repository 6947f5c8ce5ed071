import dataclasses
import math

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from kinematics.planning.grasps import OPENING_RESERVE_M, grasp_table
from kinematics.scene.planning_scene import SceneObject
from robots.models.description import load_description


def grasp_candidates(item, gripper, natural_yaw_rad, approach_m):
    """All rows of the table."""
    table = grasp_table(item, gripper, natural_yaw_rad, approach_m)
    return [table.candidate(row) for row in range(len(table))]


def candidates(talos, shape, place=(0.5, -0.2, 0.9), turn=0.0, hand="right"):
    pose = poses.transform(poses.rotation_z(turn), place)
    gripper = talos.description.grippers[hand]
    return [c.grasp for c in grasp_candidates(SceneObject("thing", shape, pose), gripper, 0.0, 0.1)]


def tilt_of(grasp):
    return -np.degrees(np.arcsin(np.clip(grasp.world_T_tcp[2, 0], -1.0, 1.0)))


def test_a_cup_is_grasped_across_its_axis_from_side_to_top(talos):
    grasps = candidates(talos, Cylinder(0.03, 0.12))

    tilts = {round(tilt_of(grasp)) for grasp in grasps}
    assert min(tilts) == 0
    assert max(tilts) == 90
    for grasp in grasps:
        assert grasp.diameter_m == pytest.approx(0.06)
        assert abs(grasp.world_T_tcp[2, 1]) < 1e-9  # the opening is horizontal
        # the TCP is on the cup's axis, inside its height
        assert grasp.world_T_tcp[:2, 3] == pytest.approx([0.5, -0.2])
        assert abs(grasp.world_T_tcp[2, 3] - 0.9) <= 0.06


def test_a_box_is_grasped_square_to_its_faces(talos):
    grasps = candidates(talos, Box((0.05, 0.2, 0.1)), turn=0.6)

    assert grasps
    for grasp in grasps:
        across = grasp.world_T_tcp[:3, 1]
        assert abs(across @ poses.rotation_z(0.6)[:, 0]) == pytest.approx(1.0)
        assert grasp.diameter_m == pytest.approx(0.05)


def test_a_ball_has_grasps(talos):
    assert candidates(talos, Ball(0.03))


@pytest.mark.parametrize(
    "shape", [Cylinder(0.045, 0.12), Box((0.1, 0.12, 0.05)), Ball(0.046)], ids=["wide cup", "box", "ball"]
)
def test_what_is_wider_than_the_hand_has_no_grasp(talos, shape):
    assert candidates(talos, shape) == []


@pytest.fixture
def gap_toothed(talos):
    """A gripper whose pads of one side leave a gap of 32 mm."""
    return dataclasses.replace(talos.description.grippers["right"], pad_gap_m=0.032)


def test_what_fits_between_neighbouring_pads_is_not_grasped_from_above(gap_toothed):
    thin = SceneObject("thing", Cylinder(0.015, 0.12), poses.translation(0.5, -0.2, 0.9))
    ball = SceneObject("thing", Ball(0.015), poses.translation(0.5, -0.2, 0.9))

    grasps = [candidate.grasp for candidate in grasp_candidates(thin, gap_toothed, 0.0, 0.1)]

    assert grasps
    assert max(tilt_of(grasp) for grasp in grasps) < 61
    assert grasp_candidates(ball, gap_toothed, 0.0, 0.1) == []


def test_what_sinks_in_between_pads_opens_them_less_and_costs_more(gap_toothed):
    cup = SceneObject("thing", Cylinder(0.03, 0.12), poses.translation(0.5, -0.2, 0.9))

    ordered = grasp_candidates(cup, gap_toothed, 0.0, 0.1)

    sunken = [c for c in ordered if tilt_of(c.grasp) > 61]
    assert all(c.grasp.diameter_m == pytest.approx(0.03 + np.sqrt(0.03**2 - 0.016**2)) for c in sunken)
    assert min(c.cost for c in sunken) > min(c.cost for c in ordered) + 0.5


def test_the_reserve_for_perception_errors_is_kept(talos):
    widest = talos.description.grippers["right"].max_opening_m / 2 - OPENING_RESERVE_M

    assert candidates(talos, Cylinder(widest - 1e-4, 0.1))
    assert not candidates(talos, Cylinder(widest + 1e-4, 0.1))


def test_both_hands_mirror_each_other(talos):
    left = candidates(talos, Cylinder(0.03, 0.12), place=(0.5, 0.2, 0.9), hand="left")
    right = candidates(talos, Cylinder(0.03, 0.12), place=(0.5, -0.2, 0.9), hand="right")

    for a, b in zip(left, right, strict=True):
        assert a.world_T_tcp[:3, 3] * (1, -1, 1) == pytest.approx(b.world_T_tcp[:3, 3])
        assert a.world_T_tcp[:3, 0] * (1, -1, 1) == pytest.approx(b.world_T_tcp[:3, 0])


def with_a_short_palm(talos):
    """The same hand, whose palm comes within 4 cm of the middle between the pads."""
    return dataclasses.replace(talos.description.grippers["right"], palm_distance_m=0.04)


@pytest.mark.parametrize("shape", [Box((0.10, 0.05, 0.12)), Cylinder(0.035, 0.12)])
def test_a_grasp_whose_palm_would_keep_the_pads_off_is_none(talos, shape):
    gripper = with_a_short_palm(talos)
    item = SceneObject("thing", shape, poses.translation(0.5, -0.2, 0.9))

    grasps = [found.grasp for found in grasp_candidates(item, gripper, 0.0, 0.1)]

    top_m = 0.9 + 0.5 * shape.height_m
    assert grasps
    assert min(tilt_of(grasp) for grasp in grasps) > 5.0
    assert all(grasp.world_T_tcp[2, 3] <= top_m - gripper.lowest_overlap_m + 1e-9 for grasp in grasps)


def test_how_far_fingertips_reach_below_what_they_grasp_from_above_is_the_grippers(talos):
    low = SceneObject("box", Box((0.05, 0.05, 0.08)), poses.translation(0.5, -0.2, 0.9))
    usual = talos.description.grippers["right"]
    short = dataclasses.replace(usual, tip_gap_m=0.02, pad_overlap_m=0.01, lowest_overlap_m=0.0)

    def lowest_m(gripper):
        found = [one.grasp for one in grasp_candidates(low, gripper, 0.0, 0.1)]
        return min(grasp.world_T_tcp[2, 3] for grasp in found if tilt_of(grasp) > 85.0)

    assert lowest_m(short) < lowest_m(usual) - 0.01


@pytest.fixture(scope="module")
def palms():
    return load_description("g1").grippers


@pytest.mark.parametrize(("robot", "tilt_rad"), [("g1", 0.0), ("talos", math.radians(20.0))])
def test_a_hand_comes_first_as_suits_it_and_level_where_closing_would_turn_the_thing(robot, tilt_rad):
    gripper = load_description(robot).grippers["right"]
    item = SceneObject("bottle", Cylinder(0.03, 0.2), poses.translation(0.4, -0.1, 0.8))

    first = grasp_candidates(item, gripper, 0.0, 0.1)[0].grasp

    assert math.asin(-first.world_T_tcp[2, 0]) == pytest.approx(tilt_rad)


@pytest.mark.parametrize("hand", ["left", "right"])
@pytest.mark.parametrize("radius", [0.02, 0.03, 0.04])
def test_a_thing_that_is_pressed_against_the_palm_begins_beside_it(palms, hand, radius):
    gripper = palms[hand]
    item = SceneObject("bottle", Cylinder(radius, 0.2), poses.translation(0.4, -0.1, 0.8))

    grasps = [c.grasp for c in grasp_candidates(item, gripper, 0.0, 0.1)]

    assert grasps
    for grasp in grasps:
        _, y, _ = (poses.inverse(grasp.world_T_tcp) @ item.world_T_object)[:3, 3]
        gap = abs(y - gripper.palm_side_m) - radius
        assert gap == pytest.approx(gripper.beside_palm_m)
        assert grasp.off_centre_m == pytest.approx(gripper.held_at_m(2 * radius))
        # the palm is to the left of a left hand, and the thing on its other side
        assert np.sign(y - gripper.palm_side_m) == (-1.0 if hand == "left" else 1.0)


@pytest.mark.parametrize(
    ("robot", "height_m", "above_m"),
    [("talos", 0.2, 0.024), ("g1", 0.2, 0.0), ("g1", 0.116, 0.008), ("g1", 0.08, 0.007)],
    ids=["a share above", "at the middle", "off what it stands on", "all fingers meet it"],
)
def test_from_the_side_a_hand_takes_hold_where_it_usually_does(robot, height_m, above_m):
    gripper = load_description(robot).grippers["right"]
    item = SceneObject("can", Cylinder(0.03, height_m), poses.translation(0.4, -0.1, 0.8))

    grasps = [c.grasp for c in grasp_candidates(item, gripper, 0.0, 0.1)]

    level = [grasp.world_T_tcp[2, 3] - 0.8 for grasp in grasps if abs(grasp.world_T_tcp[2, 0]) < 1e-6]
    assert level
    assert level == pytest.approx([above_m] * len(level))


def test_fingers_that_wrap_around_are_not_led_in_from_above(palms):
    item = SceneObject("bottle", Cylinder(0.03, 0.2), poses.translation(0.4, -0.1, 0.8))

    tilts = {round(tilt_of(c.grasp)) for c in grasp_candidates(item, palms["right"], 0.0, 0.1)}

    assert tilts == {0, 20, 40}


@pytest.mark.parametrize(("width", "at"), [(0.01, 0.0196), (0.030, 0.0196), (0.0525, 0.006), (0.2, -0.024)])
def test_where_a_thing_is_held_is_read_between_what_was_measured(palms, width, at):
    assert palms["left"].held_at_m(width) == pytest.approx(at)
    assert palms["right"].held_at_m(width) == pytest.approx(-at)


@pytest.mark.parametrize("height", [0.10, 0.14, 0.22])
def test_from_the_side_all_fingers_meet_what_they_wrap_around(palms, height):
    gripper = palms["left"]
    item = SceneObject("can", Cylinder(0.03, height), poses.translation(0.4, 0.1, 0.8))

    level = [c.grasp for c in grasp_candidates(item, gripper, 0.0, 0.1) if abs(tilt_of(c.grasp)) < 1.0]

    assert level
    for grasp in level:
        assert 0.8 + 0.5 * height - grasp.world_T_tcp[2, 3] >= gripper.side_overlap_m - 1e-9
