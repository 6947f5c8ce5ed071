"""Whether there is room: straight ahead, along a path, and to turn; by height, and with what is held."""

import dataclasses

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Ball, Box, Cylinder
from kinematics.model.robot_model import RobotModel
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.walking.route.load import Load, load_of
from kinematics.walking.route.path_planning import clearance_m
from kinematics.walking.route.room import WalkingRoom, stopping_distance_m
from robots.models.description import load_description

DESCRIPTION = load_description("talos")
SETTINGS = DESCRIPTION.walking
EMPTY = WalkingRoom(SETTINGS)
LOAD = Load(from_m=0.9, front_m=0.62, back_m=0.0, half_width_m=0.4, radius_m=0.7)
LADEN = WalkingRoom(SETTINGS, LOAD)


def scene(height_m, near_m):
    """A piece of furniture of some height whose edge is so far ahead."""
    middle = poses.translation(near_m + 0.5, 0.0, 0.5 * height_m)
    return PlanningScene().with_objects([SceneObject("it", Box((1.0, 2.0, height_m)), middle, movable=False)])


def test_what_is_beside_the_corridor_is_not_in_the_way():
    beside, ahead = np.array([[0.6, 0.8, 0.5]]), np.array([[0.6, 0.1, 0.5]])

    assert EMPTY.free_way_m(beside, 0.3) == np.inf
    assert EMPTY.free_way_m(ahead, 0.3) == pytest.approx(0.6 - SETTINGS.front_m)
    assert EMPTY.free_way_m(ahead, -0.3) == np.inf


def test_who_is_faster_stops_later():
    assert stopping_distance_m(SETTINGS, 0.5) > stopping_distance_m(SETTINGS, 0.1) > 0.0


@pytest.mark.requirement("S2")
@pytest.mark.parametrize(("height_m", "free"), [(0.6, True), (1.3, False)])
def test_a_post_beside_the_way_is_in_the_way_of_the_hands_alone(height_m, free):
    assert bool(np.isinf(EMPTY.free_way_m(np.array([(1.0, 0.7, height_m)]), 0.3))) is free


@pytest.mark.requirement("S2")
def test_what_is_held_meets_what_is_ahead_before_the_robot_does():
    ahead = np.array([(1.0, 0.0, 1.1)])

    assert EMPTY.free_way_m(ahead, 0.3) == pytest.approx(1.0 - SETTINGS.front_m)
    assert LADEN.free_way_m(ahead, 0.3) == pytest.approx(1.0 - LOAD.front_m)
    assert LADEN.free_way_m(ahead, -0.3) == np.inf


def test_what_is_lower_than_the_load_is_in_the_way_of_the_robot_alone():
    below = np.array([(1.0, 0.0, LOAD.from_m - SETTINGS.sway_m - 0.01)])

    assert LADEN.free_way_m(below, 0.3) == EMPTY.free_way_m(below, 0.3)


@pytest.mark.parametrize(
    ("height_m", "needed_m", "part"),
    [
        (0.80, SETTINGS.legs_radius_m + SETTINGS.sway_m, "legs"),
        (1.20, SETTINGS.hands_radius_m + SETTINGS.sway_m, "hands"),
    ],
)
def test_legs_turn_nearer_to_low_things_than_hands_do_to_tall_ones(height_m, needed_m, part):
    tight = EMPTY.tightest(scene(height_m, needed_m - 0.01), PlanarPose())

    assert (tight.part, tight.lack_m) == (part, pytest.approx(0.01))
    assert EMPTY.tightest(scene(height_m, needed_m + 0.01), PlanarPose()).lack_m < 0.0


def test_what_is_held_low_turns_in_a_wider_circle_than_the_legs():
    shelf = scene(0.95, LOAD.radius_m)

    tight = LADEN.tightest(shelf, PlanarPose())

    assert EMPTY.tightest(shelf, PlanarPose()).lack_m < 0.0
    assert (tight.part, tight.lack_m) == ("load", pytest.approx(SETTINGS.sway_m))


@pytest.mark.parametrize(
    ("room", "point", "part"),
    [
        (EMPTY, (0.61, 0.0, 0.3), "body"),
        (EMPTY, (0.0, 0.85, 1.15), "hands"),
        (LADEN, (0.0, -0.75, 0.95), "load"),
    ],
)
def test_what_is_seen_bars_a_turn_at_its_own_height_though_nobody_knows_it(room, point, part):
    tight = room.tightest_seen(np.array([point]))

    assert tight.part == part
    assert tight.lack_m > 0.0
    assert room.tightest_seen(1.5 * np.array([point])).lack_m < 0.0


@pytest.mark.parametrize("angle_rad", [-3.0, -1.5, 0.0, 1.0, 2.9])
@pytest.mark.parametrize("turn_rad", [-1.3, 0.4, 3.1])
def test_a_turn_meets_just_what_is_met_at_one_of_its_headings(angle_rad, turn_rad):
    spare_m = 0.02 + SETTINGS.sway_m
    hands_m = SETTINGS.hands_radius_m + spare_m
    sides_m = SETTINGS.hands_half_width_m + spare_m
    for away_m in np.arange(0.3, 1.1, 0.05):
        point = np.array([[away_m * np.cos(angle_rad), away_m * np.sin(angle_rad), 1.2]])
        seen = angle_rad - np.linspace(0.0, turn_rad, 500)
        x, y = away_m * np.cos(seen), away_m * np.sin(seen)
        meets = (x <= SETTINGS.front_m + spare_m) & (-x <= SETTINGS.back_m + spare_m) & (np.abs(y) <= sides_m)
        met = bool(away_m <= hands_m and meets.any())

        assert (EMPTY.turn_meets(point, turn_rad) is not None) == met


def test_a_load_that_stands_out_meets_more_in_a_turn_than_hands_do():
    ahead = np.array([[0.68, 0.1, 1.0]])

    assert EMPTY.turn_meets(ahead, 0.4) is None
    assert LADEN.turn_meets(ahead, 0.4) == "load"
    assert LADEN.turn_meets(ahead - (0.0, 0.0, 0.5), 0.4) is None


def test_who_can_choose_keeps_from_low_things_what_a_walk_keeps_from_them():
    table = scene(0.80, 0.5)

    assert EMPTY.tightest(table, PlanarPose()).lack_m < 0.0
    assert EMPTY.tightest(table, PlanarPose(), at_ease=True).lack_m == pytest.approx(0.62 - 0.5)


@pytest.mark.parametrize(
    ("height_m", "wider_m"), [(0.7, 0.0), (0.95, LOAD.radius_m - SETTINGS.half_width_m), (1.2, 0.2)]
)
def test_a_path_keeps_farther_from_what_meets_a_wider_part(height_m, wider_m):
    taken = LADEN.footprints(scene(height_m, 2.0))

    assert clearance_m(taken, PlanarPose()) == pytest.approx(2.0 - wider_m)


def test_what_is_held_is_as_large_as_it_is():
    model = RobotModel(DESCRIPTION)
    frame = DESCRIPTION.tcp_frames["left"]
    hand = model.frame_pose(model.q_home, frame)
    level = poses.inverse(hand)
    level[:3, 3] = 0.0  # the box is level, its middle between the fingers
    box = SceneObject("box", Box((0.30, 0.10, 0.20)), hand @ level)
    held = PlanningScene().with_objects([box]).with_attached("box", frame, level, ())

    load = load_of(model, model.q_home, held.attached.values(), SETTINGS.hand_radius_m)

    x, y, z = hand[:3, 3] - (*model.q_home[:2], 0.0)
    assert load.from_m == pytest.approx(z - 0.10)
    assert load.front_m == pytest.approx(x + 0.15)
    assert load.back_m == pytest.approx(0.15 - x)
    assert load.half_width_m == pytest.approx(y + SETTINGS.hand_radius_m, rel=0.01)  # wider than the box
    assert load.radius_m >= np.hypot(x + 0.15, y + 0.05) - 1e-9


def test_the_load_turns_with_the_robot():
    model = RobotModel(DESCRIPTION)
    frame = DESCRIPTION.tcp_frames["left"]
    cup = SceneObject("cup", Cylinder(0.03, 0.30), np.eye(4))
    held = PlanningScene().with_objects([cup]).with_attached("cup", frame, np.eye(4), ())
    turned = model.q_home.copy()
    turned[:7] = (2.0, -1.0, turned[2], 0.0, 0.0, np.sin(0.6), np.cos(0.6))

    loads = [load_of(model, q, held.attached.values(), 0.08) for q in (model.q_home, turned)]

    assert dataclasses.astuple(loads[1]) == pytest.approx(dataclasses.astuple(loads[0]))


@pytest.mark.parametrize("shape", [Ball(0.15), Cylinder(0.15, 0.30), Box((0.30, 0.30, 0.30))])
def test_every_shape_stands_out_by_half_its_size(shape):
    model = RobotModel(DESCRIPTION)
    frame = DESCRIPTION.tcp_frames["left"]
    hand = model.frame_pose(model.q_home, frame)
    level = poses.inverse(hand)
    level[:3, 3] = 0.0
    held = (
        PlanningScene().with_objects([SceneObject("it", shape, hand)]).with_attached("it", frame, level, ())
    )

    load = load_of(model, model.q_home, held.attached.values(), 0.05)

    assert load.front_m == pytest.approx(hand[0, 3] - model.q_home[0] + 0.15, abs=0.003)
    assert load.from_m == pytest.approx(hand[2, 3] - 0.15)


def test_empty_hands_have_no_load():
    model = RobotModel(DESCRIPTION)

    assert load_of(model, model.q_home, (), 0.08) is None
