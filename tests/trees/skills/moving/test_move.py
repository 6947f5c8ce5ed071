"""Moving at a velocity, without a robot that walks."""

import dataclasses

import numpy as np
import pytest
from py_trees.common import Status

from kinematics.geometry.shapes import Box
from robots.control.motion_handle import MotionHandle, MotionStatus
from trees.failures import FailureKind
from trees.skills.moving.tree import Move
from trees.tasks import MoveTask


class FakeWalking:
    """Notes what is asked of it."""

    def __init__(self):
        self.handle = None
        self.cancelled = []

    @property
    def active(self):
        return self.handle is not None and not self.handle.finished

    def walk(self, steering, name):
        self.steering, self.handle = steering, MotionHandle(name, "walk-1")
        return self.handle

    def steer(self, handle, steering):
        self.steering = steering

    def finish(self, handle):
        handle.status = MotionStatus.DONE

    def cancel(self, handle, reason):
        handle.status = MotionStatus.CANCELED
        self.cancelled.append(reason)


class Ranges:
    """Sees what it is told."""

    def __init__(self, *points):
        self.points = np.array(points, dtype=float).reshape(-1, 3)

    def scan(self):
        return self.points


@pytest.fixture
def move(stage):
    """Makes the leaf for a task, on a stage that can walk."""

    def make(task, ranges=None):
        walking = FakeWalking()
        toolbox = dataclasses.replace(stage.toolbox, walking=walking, ranging=ranges or Ranges())
        return stage.ready(Move("walk", toolbox), task=task), walking

    return make


@pytest.mark.requirement("S1")
@pytest.mark.parametrize(
    ("linear", "angular", "limit"),
    [(0.51, 0.0, 0.5), (-0.6, 0.0, 0.5), (0.0, 1.01, 1.0), (float("nan"), 0.0, 0.5)],
)
def test_a_velocity_beyond_the_limit_is_refused_with_limit_and_value(move, linear, angular, limit):
    leaf, walking = move(MoveTask("go", linear, angular, 1.0))

    leaf.tick_once()

    assert leaf.status is Status.FAILURE
    assert leaf.failure.kind is FailureKind.REFUSED
    assert leaf.failure.numbers["limit"] == pytest.approx(limit)
    assert walking.handle is None


@pytest.mark.requirement("S2")
def test_nothing_moves_towards_an_obstacle_nearer_than_the_stopping_distance(move):
    leaf, walking = move(MoveTask("go", 0.3, 0.0, 1.0), Ranges((0.5, 0.0, 0.9)))

    leaf.tick_once()

    assert leaf.status is Status.FAILURE
    assert "obstacle" in leaf.failure.message
    assert walking.handle is None


@pytest.mark.requirement("S2")
@pytest.mark.parametrize(("length_m", "status"), [(0.06, Status.RUNNING), (0.30, Status.FAILURE)])
@pytest.mark.parametrize("shelf_m", [(0.7, 0.82, 1.25), (0.74, 0.0, 1.25)])
def test_what_is_held_does_not_brush_by_a_shelf(move, hold_level, length_m, status, shelf_m):
    hold_level(Box((length_m, length_m, 0.10)))
    leaf, _ = move(MoveTask("go", 0.3, 0.0, 1.0), Ranges(shelf_m))

    leaf.tick_once()

    assert leaf.status is status


@pytest.mark.requirement("S2")
def test_a_walk_stops_when_an_obstacle_comes_near(move, stage):
    ranges = Ranges((2.0, 0.0, 0.9))
    leaf, walking = move(MoveTask("go", 0.3, 0.0, 5.0), ranges)
    leaf.tick_once()
    assert leaf.status is Status.RUNNING

    ranges.points = np.array([[0.4, 0.0, 0.9]])
    for _ in range(400):
        stage.fake.step()
        leaf.tick_once()
        if leaf.status is not Status.RUNNING:
            break

    assert leaf.status is Status.FAILURE
    assert walking.cancelled


@pytest.mark.requirement("S2")
def test_nothing_moves_before_the_range_sensor_has_spoken(move, stage):
    ranges = Ranges((2.0, 0.0, 0.9))
    seen, ranges.points = ranges.points, None
    leaf, walking = move(MoveTask("go", 0.3, 0.0, 5.0), ranges)
    for _ in range(10):
        leaf.tick_once()
        stage.fake.step()
    assert leaf.status is Status.RUNNING
    assert walking.handle is None

    ranges.points = seen
    leaf.tick_once()

    assert walking.handle is not None


@pytest.mark.requirement("S2", "F5")
def test_a_walk_stops_when_the_range_sensor_falls_silent(move, stage):
    ranges = Ranges((2.0, 0.0, 0.9))
    leaf, walking = move(MoveTask("go", 0.3, 0.0, 5.0), ranges)
    leaf.tick_once()
    assert leaf.status is Status.RUNNING

    ranges.points = None
    for _ in range(10):
        stage.fake.step()
        leaf.tick_once()
        if leaf.status is not Status.RUNNING:
            break

    assert leaf.status is Status.FAILURE
    assert "silent" in leaf.failure.message
    assert walking.cancelled


def test_an_obstacle_ahead_does_not_keep_it_from_going_back(move):
    leaf, _ = move(MoveTask("back", -0.3, 0.0, 1.0), Ranges((0.5, 0.0, 0.9)))

    leaf.tick_once()

    assert leaf.status is Status.RUNNING


@pytest.mark.requirement("S2")
@pytest.mark.parametrize(
    ("angular", "duration_s", "seen_m", "status"),
    [
        (0.5, 2.5, (0.66, 0.0, 1.2), Status.FAILURE),  # a shelf ahead, where the right hand comes by
        (-0.5, 2.5, (0.66, 0.0, 1.2), Status.FAILURE),
        (0.5, 2.5, (0.66, 0.0, 0.7), Status.RUNNING),  # lower than the hands
        (0.5, 2.5, (1.1, 0.0, 1.2), Status.RUNNING),  # farther than the hands
        (0.5, 0.4, (-0.7, 0.0, 1.2), Status.RUNNING),  # behind, and no hand comes as far
        (0.5, 6.2, (-0.7, 0.0, 1.2), Status.FAILURE),
    ],
)
def test_a_turn_for_which_the_hands_have_no_room_is_not_begun(move, angular, duration_s, seen_m, status):
    leaf, walking = move(MoveTask("turn", 0.0, angular, duration_s), Ranges(seen_m))

    leaf.tick_once()

    assert leaf.status is status
    if status is Status.FAILURE:
        assert leaf.failure.kind is FailureKind.INFEASIBLE  # a step away helps
        assert leaf.failure.message == "there is no room to turn for the hands"
        assert walking.handle is None


def test_what_the_robot_holds_does_not_bar_its_own_turn(move, hold_level):
    hold_level(Box((0.06, 0.06, 0.10)))
    leaf, _ = move(MoveTask("turn", 0.0, 0.5, 2.5), Ranges((0.5, -0.35, 0.3)))

    leaf.tick_once()

    assert leaf.status is Status.RUNNING
