"""What is seen in a hand, or has slid in it, is no second thing."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.scene.planning_scene import SceneObject
from robots.perception.object_estimate import ObjectEstimate
from trees.skills.looking.folded_look import not_in_hand

HAND = "tcp_right"
CUP = Cylinder(0.03, 0.11)


def seen(place, color="red"):
    return ObjectEstimate("object", "cup", color, poses.translation(*place), CUP, 0.9, 8, 0.003)


def seen_top(place, top_m):
    pose = poses.translation(place[0], place[1], top_m - 0.02)
    return ObjectEstimate("furniture", "table", None, pose, Box((0.4, 0.4, 0.04)), 0.9, 8, 0.003)


@pytest.fixture
def holding(stage):
    """The stage, with a red cup in its right hand."""
    cup = SceneObject("red cup", CUP, poses.translation(0.4, 0.0, 1.0), 0.005, True)
    stage.told.update(stage.told.scene.with_object(cup).with_attached(cup.name, HAND, np.eye(4), []))
    return stage


@pytest.fixture
def hand_m(holding):
    return holding.toolbox.model.frame_pose(holding.fake.sensing.state().q, HAND)[:3, 3]


@pytest.mark.parametrize(
    ("off_m", "color", "is_another"),
    [
        ((0.03, 0.0, 0.0), "red", False),
        ((0.03, 0.0, 0.0), "blue", False),
        ((0.04, 0.06, -0.03), "red", False),
        ((0.04, 0.06, -0.03), "blue", True),
        ((0.2, 0.2, 0.0), "red", True),
    ],
)
def test_what_looks_like_the_held_thing_and_hangs_near_it_is_that(holding, hand_m, off_m, color, is_another):
    estimate = seen(hand_m + off_m, color)

    assert not_in_hand(holding.toolbox, [estimate]) == ([estimate] if is_another else [])


def test_what_stands_near_the_held_thing_is_another_one(holding, hand_m):
    place = hand_m + np.array((0.0, 0.08, 0.0))
    estimate, top = seen(place), seen_top(place, place[2] - 0.055)

    assert not_in_hand(holding.toolbox, [estimate, top]) == [estimate, top]
    assert not_in_hand(holding.toolbox, [estimate]) == []


def test_with_empty_hands_everything_is_seen(stage):
    assert len(not_in_hand(stage.toolbox, [seen((0.4, -0.2, 1.0))])) == 1


@pytest.mark.requirement("P2")
@pytest.mark.parametrize(("aside_m", "is_another"), [(0.0, False), (0.12, True)])
def test_what_seems_to_reach_from_the_hand_down_to_the_table_is_the_held_thing(
    holding, hand_m, aside_m, is_another
):
    pose = poses.translation(hand_m[0] + aside_m, hand_m[1], hand_m[2] - 0.08)
    tall = ObjectEstimate("object", "bottle", "red", pose, Cylinder(0.03, 0.27), 0.9, 8, 0.003)
    top = seen_top(pose[:3, 3], pose[2, 3] - 0.135)

    assert (tall in not_in_hand(holding.toolbox, [tall, top])) == is_another
