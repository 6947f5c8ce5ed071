"""Ways to a goal past what is known and past what was only seen."""

import itertools

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.walking.route.room import WalkingRoom
from kinematics.walking.route.ways import Way, WayFinder
from robots.models.description import load_description

SETTINGS = load_description("talos").walking
STRAIGHT_M = 0.45
GOAL = PlanarPose(2.0, 0.0, -0.9)


@pytest.mark.requirement("S2")
@pytest.mark.parametrize("aside", [1.4, -1.2, 2.2])
@pytest.mark.parametrize(("away_m", "fits"), [(0.7, False), (1.4, True)])
def test_hands_do_not_turn_where_somebody_was_only_felt(aside, away_m, fits):
    body = PlanarPose(0.4, -0.3, 0.8)
    around = np.linspace(-0.3, 0.3, 13) + body.yaw_rad + aside
    somebody = np.column_stack([body.x_m + away_m * np.cos(around), body.y_m + away_m * np.sin(around)])
    goal = body @ PlanarPose(3.0, 0.0, 0.3)

    def way(tucked, points):
        room = WalkingRoom(SETTINGS, tucked=tucked)
        return WayFinder(SETTINGS, room, PlanningScene(), points, STRAIGHT_M, True, points).find(body, goal)

    assert isinstance(way(False, somebody), Way) is fits
    assert isinstance(way(True, somebody), Way)


def wall(x_m, low_m, high_m):
    """Points of a wall across the floor, shape (n, 2)."""
    return np.array([(x_m, y_m) for y_m in np.arange(low_m, high_m, 0.05)])


def way_past(points, scene=None):
    """The way to the goal from beside it, where nothing was seen but these points."""
    finder = WayFinder(SETTINGS, WalkingRoom(SETTINGS), scene or PlanningScene(), points, STRAIGHT_M)
    way = finder.find(PlanarPose(2.4, 2.6, -1.6), GOAL)
    assert isinstance(way, Way)
    return way


def nearest_m(way, points):
    """Least distance of the whole way to the points, the last stretch to the goal included."""
    corners = [*way.path, GOAL]
    line = np.concatenate(
        [np.linspace((a.x_m, a.y_m), (b.x_m, b.y_m), 20) for a, b in itertools.pairwise(corners)]
    )
    return float(np.linalg.norm(line[:, None] - points[None], axis=2).min())


@pytest.mark.requirement("S2")
def test_the_last_stretch_to_the_goal_begins_where_it_is_free():
    way = way_past(np.array([(-3.0, -3.0)]))

    before = way.path[-1].to(GOAL)
    assert before.x_m == pytest.approx(STRAIGHT_M)
    assert before.y_m == pytest.approx(0.0, abs=1e-9)


@pytest.mark.requirement("S2")
def test_it_does_not_begin_inside_what_was_seen_and_is_nothing_known():
    there = GOAL @ PlanarPose(-STRAIGHT_M)
    seen = wall(there.x_m - 0.1, there.y_m, 1.5)

    way = way_past(seen)

    assert nearest_m(way, seen) >= SETTINGS.legs_radius_m


@pytest.mark.requirement("S2")
def test_nor_inside_what_is_known():
    there = GOAL @ PlanarPose(-STRAIGHT_M)
    middle = poses.translation(there.x_m - 0.35, there.y_m + 0.75, 0.4)
    scene = PlanningScene().with_objects([SceneObject("box", Box((0.5, 1.5, 0.8)), middle, movable=False)])

    way = way_past(np.zeros((0, 2)), scene)

    assert nearest_m(way, wall(there.x_m - 0.1, there.y_m, there.y_m + 1.5)) >= SETTINGS.legs_radius_m
