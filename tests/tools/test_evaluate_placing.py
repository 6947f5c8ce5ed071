"""What the suite of place asks for can be done, and everything else of an episode stays as it was drawn."""

import math

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from robots.scenes.scene_description import Furniture, SceneItem
from tools.evaluate.skills.episode import trial_of
from tools.evaluate.skills.placing import BESIDE_M, DIRECTION_RAD, turned_rad
from tools.evaluate.skills.room_beside import has_room

TABLE = Furniture("table", "table", (0.6, 1.2, 0.8), (0.62, 0.0))
IN_FRONT = [math.pi]


def standing(name, x, y):
    place = poses.translation(x, y, 0.86)
    return SceneItem(name, "cup", "red", Cylinder(0.03, 0.12), 0.2, 0.6, place)


def room_in_front(of_x, *others):
    item, other = standing("item", 0.8, 0.5), standing("other", of_x, 0.0)
    return has_room(item, other, [item, other, *others], TABLE, IN_FRONT, DIRECTION_RAD, BESIDE_M)


def test_there_is_room_in_front_of_what_stands_in_the_middle():
    assert room_in_front(0.62)


def test_there_is_none_in_front_of_what_stands_at_the_edge():
    assert not room_in_front(0.40)


def test_there_is_none_where_other_things_stand():
    crowd = [standing(f"cup {i}", 0.40, 0.08 * i) for i in range(-4, 5)]

    assert not room_in_front(0.50, *crowd)


@pytest.mark.requirement("M3")
@pytest.mark.parametrize("seed", [240002, 240013, 250001, 250004])
def test_nobody_is_asked_to_put_something_where_it_would_fall_off(seed):
    trial = trial_of("place", seed)

    assert trial.tasks[-1].to.relation.kind != "in_front_of"


def test_what_can_be_done_is_asked_for_as_it_was_drawn():
    assert trial_of("place", 3124).tasks[-1].to.relation.kind == "in_front_of"
    assert np.isclose(trial_of("place", 3124).scene.robot_start.x_m, 0.025534452877446705)


@pytest.mark.parametrize(
    ("size_m", "turn_deg", "looks_deg"),
    [
        ((0.04, 0.08, 0.1), 178.0, 2.0),
        ((0.04, 0.08, 0.1), 90.0, 90.0),
        ((0.06, 0.06, 0.1), 91.0, 1.0),
        ((0.04, 0.08, 0.1), 6.0, 6.0),
    ],
)
def test_a_box_is_turned_as_far_as_it_looks_turned(size_m, turn_deg, looks_deg):
    assert math.degrees(turned_rad(Box(size_m), math.radians(turn_deg))) == pytest.approx(looks_deg)


@pytest.mark.parametrize(
    ("seen_m", "turn_deg", "looks_deg"),
    [
        ((0.079, 0.042, 0.1), 90.0, 0.0),
        ((0.079, 0.042, 0.1), 0.0, 90.0),
        ((0.041, 0.078, 0.1), 90.0, 90.0),
    ],
)
def test_a_box_whose_long_side_is_along_the_other_axis_of_belief_is_compared_side_by_side(
    seen_m, turn_deg, looks_deg
):
    turned = turned_rad(Box((0.04, 0.08, 0.1)), math.radians(turn_deg), Box(seen_m))

    assert math.degrees(turned) == pytest.approx(looks_deg, abs=1e-6)
