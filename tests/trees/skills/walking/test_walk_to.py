"""The way that a walk takes between a low thing and a tall one, where the arms go over the low one."""

import dataclasses

import numpy as np
import pytest
from py_trees.common import Status

from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box
from kinematics.scene.planning_scene import SceneObject
from kinematics.walking.pattern.steering import StretchSteering
from robots.control.motion_handle import MotionHandle
from robots.fake.fake_sensing import FakeRangeSensor
from trees.beliefs.grounding.destination import Place
from trees.skills.walking.draw_arms_in import DrawArmsIn
from trees.skills.walking.reachable_standing import Stand
from trees.skills.walking.walk_to import WalkTo

_ACROSS_M = 1.5
_FAR_M = 6.0


class FeetThatSetOut:
    """Walking that notes what it is asked for, and never arrives."""

    active = False

    def __init__(self):
        self.asked = []

    def walk(self, steering, name):
        self.asked.append(steering)
        return MotionHandle(name, "feet")


@pytest.fixture
def between(stage):
    """Walks through a gap between two walls of given heights, too long to go around."""

    def run(left_m, right_m, gap_m=1.4, if_hands_fit=False):
        walls = [
            SceneObject(
                name,
                Box((0.1, _FAR_M, height_m)),
                poses.translation(_ACROSS_M, side * 0.5 * (gap_m + _FAR_M), 0.5 * height_m),
                0.015,
                movable=False,
            )
            for name, side, height_m in (("counter", 1.0, left_m), ("wall", -1.0, right_m))
        ]
        stage.told.update(stage.told.scene.with_objects(walls))
        feet = FeetThatSetOut()
        toolbox = dataclasses.replace(stage.toolbox, walking=feet, ranging=None)
        leaf = WalkTo("walk", toolbox, if_hands_fit)
        aim = Box((0.4, 0.4, 0.9))
        place = Place("table", "furniture", aim, poses.translation(3.2, 0.0, 0.45), 0.9)
        stage.ready(leaf, place=place)
        status = stage.tick(leaf)
        way = feet.asked[0].path if feet.asked else ()
        return status, np.array([(one.x_m, one.y_m) for one in way])

    return run


def across(way):
    """Where a way passes between the walls."""
    return float(np.interp(_ACROSS_M, way[:, 0], way[:, 1]))


def test_between_a_low_and_a_tall_thing_the_way_is_nearer_to_the_low_one(between):
    status, way = between(0.9, 1.6)

    assert status is Status.RUNNING
    assert 0.82 - 0.05 < across(way) + 0.7 < 1.4 - 0.47 + 0.05


@pytest.mark.parametrize("left_m", [0.9, 1.6])
def test_a_gap_for_which_arms_are_too_wide_is_not_walked_through(between, left_m):
    status, _ = between(left_m, 1.6, gap_m=1.2)

    assert status is Status.FAILURE


@pytest.mark.parametrize(("length_m", "status"), [(0.06, Status.RUNNING), (0.30, Status.FAILURE)])
def test_a_gap_that_hands_fit_through_is_too_narrow_for_what_they_hold(between, hold_level, length_m, status):
    hold_level(Box((length_m, length_m, 0.10)))

    assert between(1.6, 1.6, gap_m=1.75)[0] is status


def test_a_gap_that_hands_do_not_fit_through_is_walked_through_with_arms_drawn_in(stage, between):
    assert stage.run(DrawArmsIn("draw the arms in", stage.toolbox)) is Status.SUCCESS

    assert between(1.6, 1.6, gap_m=1.2)[0] is Status.RUNNING
    assert between(1.6, 1.6, gap_m=1.0)[0] is Status.FAILURE


@pytest.mark.parametrize(("gap_m", "status"), [(1.5, Status.RUNNING), (1.3, Status.FAILURE)])
def test_hands_that_would_brush_along_a_wall_say_so_before_the_robot_sets_out(between, gap_m, status):
    assert between(0.9, 1.6, gap_m, if_hands_fit=True)[0] is status


@pytest.mark.parametrize(("high_m", "back"), [(0.9, True), (1.6, False)])
def test_the_robot_steps_back_to_turn_only_where_its_hands_come_to_nothing(stage, high_m, back):
    ahead = SceneObject("table", Box((0.4, 0.4, 0.8)), poses.translation(0.6, 0.0, 0.4), movable=False)
    behind = SceneObject(
        "door", Box((0.02, 0.3, high_m)), poses.translation(-0.42, 0.8, 0.5 * high_m), movable=False
    )
    stage.told.update(stage.told.scene.with_objects([ahead, behind]))
    feet = FeetThatSetOut()
    toolbox = dataclasses.replace(stage.toolbox, walking=feet, ranging=None)
    aim = Box((0.4, 0.4, 0.9))
    place = Place("counter", "furniture", aim, poses.translation(0.0, 3.0, 0.45), 0.9)
    leaf = WalkTo("walk", toolbox)
    stage.ready(leaf, place=place)
    stage.tick(leaf)

    assert isinstance(feet.asked[0], StretchSteering) is back


@pytest.mark.parametrize(
    ("behind_m", "aside_m", "high_m", "back"),
    [
        (0.36, 0.75, 1.4, False),
        (0.0, 0.75, 1.4, False),
        (-0.25, 0.3, 1.4, True),
        (0.36, 0.75, 0.6, True),
        (0.36, 1.2, 1.4, True),
        (0.45, 0.1, 0.1, False),
    ],
)
def test_the_robot_steps_back_into_nothing_that_only_its_range_sensor_has_seen(
    stage, behind_m, aside_m, high_m, back
):
    ahead = SceneObject("table", Box((0.4, 0.4, 0.8)), poses.translation(0.6, 0.0, 0.4), movable=False)
    stage.told.update(stage.told.scene.with_objects([ahead]))
    feet, sensor = FeetThatSetOut(), FakeRangeSensor()
    sensor.points_m = np.array([(-behind_m, aside_m, z) for z in np.arange(0.1, high_m + 0.01, 0.1)])
    place = Place("counter", "furniture", Box((0.4, 0.4, 0.9)), poses.translation(0.0, 3.0, 0.45), 0.9)
    leaf = WalkTo("walk", dataclasses.replace(stage.toolbox, walking=feet, ranging=sensor))
    stage.ready(leaf, place=place)
    stage.tick(leaf)

    assert any(isinstance(one, StretchSteering) for one in feet.asked) is back


@pytest.mark.parametrize(("tip_m", "back"), [(0.02, True), (-0.02, False)])
def test_a_door_beside_drawn_in_hands_is_stepped_back_from(stage, tip_m, back):
    assert stage.run(DrawArmsIn("draw the arms in", stage.toolbox)) is Status.SUCCESS
    at = poses.translation(0.2, 0.45 + tip_m + 0.02, 0.75)
    door = SceneObject("door", Box((0.04, 0.04, 1.5)), at, movable=False)
    stage.told.update(stage.told.scene.with_objects([door]))
    feet = FeetThatSetOut()
    leaf = WalkTo("walk", dataclasses.replace(stage.toolbox, walking=feet, ranging=None))
    place = Place("counter", "furniture", Box((0.4, 0.4, 0.9)), poses.translation(-3.0, 0.0, 0.45), 0.9)
    stage.ready(leaf, place=place)
    stage.tick(leaf)

    assert isinstance(feet.asked[0], StretchSteering) is back


def test_with_something_behind_as_well_the_robot_steps_back_to_the_middle(stage):
    ahead = SceneObject("table", Box((0.4, 0.4, 0.8)), poses.translation(0.6, 0.0, 0.4), movable=False)
    behind = SceneObject("chair", Box((0.4, 0.4, 0.8)), poses.translation(-0.85, 0.0, 0.4), movable=False)
    stage.told.update(stage.told.scene.with_objects([ahead, behind]))
    feet = FeetThatSetOut()
    aim = Box((0.4, 0.4, 0.9))
    place = Place("counter", "furniture", aim, poses.translation(0.0, 3.0, 0.45), 0.9)
    leaf = WalkTo("walk", dataclasses.replace(stage.toolbox, walking=feet, ranging=None))
    stage.ready(leaf, place=place)
    stage.tick(leaf)

    (back,) = feet.asked
    assert isinstance(back, StretchSteering)
    assert 0.05 < back.distance_m < 0.2


def test_drawn_in_hands_may_end_at_the_edge_of_what_the_walk_leads_to(stage):
    assert stage.run(DrawArmsIn("draw the arms in", stage.toolbox)) is Status.SUCCESS
    shape, pose = Box((0.6, 1.2, 1.0)), poses.translation(2.0, 0.0, 0.5)
    stage.told.update(stage.told.scene.with_objects([SceneObject("table", shape, pose, movable=False)]))
    feet = FeetThatSetOut()
    leaf = WalkTo("walk", dataclasses.replace(stage.toolbox, walking=feet, ranging=None))
    place = Place("table", "furniture", shape, pose, 0.9)
    stage.ready(leaf, place=place, stand=Stand.beside(place, PlanarPose(1.7 - 0.33)))

    assert stage.tick(leaf) is Status.RUNNING
    assert len(feet.asked) == 1


class Slow(FakeRangeSensor):
    """Says nothing until it was asked so often; whoever asks computes for seconds in between."""

    def __init__(self, clock, first_at, computing_s=0.0):
        super().__init__()
        self.clock, self.first_at, self.computing_s, self.asked = clock, first_at, computing_s, 0

    def scan(self):
        self.asked += 1
        self.silent = self.asked < self.first_at
        self.clock.advance(self.computing_s)
        return super().scan()


@pytest.fixture
def beside(stage):
    """Walks on an open floor with a range sensor."""

    def run(sensor, ticks):
        feet = FeetThatSetOut()
        leaf = WalkTo("walk", dataclasses.replace(stage.toolbox, walking=feet, ranging=sensor))
        aim = Place("table", "furniture", Box((0.4, 0.4, 0.9)), poses.translation(3.2, 0.0, 0.45), 0.9)
        stage.ready(leaf, place=aim)
        return [stage.tick(leaf) for _ in range(ticks)], leaf, feet.asked

    return run


def test_who_computed_for_long_has_not_waited_for_the_sensor(beside, stage):
    statuses, _, asked = beside(Slow(stage.fake.clock, 3, computing_s=4.0), 3)

    assert statuses == [Status.RUNNING] * 3
    assert len(asked) == 1


def test_a_sensor_that_stays_silent_ends_the_walk_before_it_begins(beside, stage):
    statuses, leaf, asked = beside(Slow(stage.fake.clock, 10_000, computing_s=0.02), 26)

    assert statuses.index(Status.FAILURE) == 25  # of 40 ms
    assert leaf.failure.message == "the range sensor says nothing"
    assert asked == []
