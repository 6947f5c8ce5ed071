"""Where to stand to see behind something tall: beside it, where there is room, and behind each thing once."""

import math

import pytest
from py_trees.common import Status

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.scene.planning_scene import SceneObject
from trees.readings.odometry import feet_pose
from trees.skills.searching.choose_outlook import ChooseOutlook

SIZE_M = (0.6, 0.6, 1.7)


def block(name, x, y=0.0, size=SIZE_M):
    return SceneObject(name, Box(size), poses.translation(x, y, 0.5 * size[2]), movable=False)


@pytest.fixture
def choose(stage):
    leaf = ChooseOutlook("choose", stage.toolbox, {"hiding_before": "hiding"})

    def run(*things):
        if things:
            stage.told.update(stage.told.scene.with_objects(things))
        return stage.run(leaf)

    return run


def outlook(stage):
    return stage.output("outlook").body(stage.output("hides"))


def sees_past(stand, corner, hidden):
    """Whether a corner that hid a point from home lies beside the line of sight to it."""
    to_corner = math.atan2(corner[1] - stand.y_m, corner[0] - stand.x_m)
    to_hidden = math.atan2(hidden[1] - stand.y_m, hidden[0] - stand.x_m)
    return abs(to_corner - to_hidden) > 0.05


def test_one_stands_beside_it_level_with_it_and_faces_what_it_hides(stage, choose):
    assert choose(block("fridge", 3.0, 0.4)) is Status.SUCCESS

    stand = outlook(stage)
    assert stand.distance_m(feet_pose(stage.toolbox)) == pytest.approx(3.1, abs=0.3)
    assert 0.9 < abs(stand.y_m - 0.4) - 0.3 < 1.3
    hidden = (4.5, 0.55)
    assert abs(math.atan2(hidden[1] - stand.y_m, hidden[0] - stand.x_m) - stand.yaw_rad) < math.radians(30.0)
    assert sees_past(stand, (3.3, 0.7 if stand.y_m > 0.4 else 0.1), hidden)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_the_side_that_has_room_is_taken(stage, choose, side):
    beside = block("counter", 3.0, -1.3 * side, (1.0, 1.0, 0.9))

    assert choose(block("fridge", 3.0, 0.1 * side), beside) is Status.SUCCESS
    assert outlook(stage).y_m * side > 1.0


def test_each_thing_is_looked_behind_once_whatever_it_is_made_of(stage, choose):
    parts = block("fridge", 3.0, -0.3, (0.6, 0.02, 1.7)), block("fridge 2", 3.0, 0.3, (0.6, 0.02, 1.7))

    assert choose(*parts, block("shelf", 0.0, 4.0)) is Status.SUCCESS
    assert stage.output("hides").name in ("fridge", "fridge 2")
    assert choose() is Status.SUCCESS
    assert stage.output("hides").name == "shelf"
    assert choose() is Status.FAILURE
    assert "nothing tall" in stage.failed()[-1].message


@pytest.mark.parametrize(
    "thing",
    [
        block("table", 3.0, size=(0.6, 0.6, 0.8)),
        block("wall", 3.0, size=(0.1, 4.0, 2.5)),
        block("fridge", 9.0),
    ],
)
def test_nobody_looks_behind_what_hides_nothing_is_a_wall_or_far_away(choose, thing):
    assert choose(thing) is Status.FAILURE
