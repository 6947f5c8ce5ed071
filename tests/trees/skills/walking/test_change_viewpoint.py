"""Who turns on the spot swings the hands around, over a table and whatever stands on it."""

import dataclasses

import numpy as np
import pytest
from py_trees.common import Status

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.scene.planning_scene import SceneObject
from robots.control.motion_handle import MotionHandle, MotionStatus
from trees.failures import FailureKind
from trees.skills.walking.change_viewpoint import ChangeViewpoint


class FeetThatSetOut:
    """Walking that never arrives."""

    active = False

    def walk(self, steering, name):
        self.active, self.handle = True, MotionHandle(name, "feet")
        return self.handle


class SeesNothingNear:
    """A range sensor under which everything passes."""

    def scan(self):
        return np.array([[2.0, 0.0, 0.5]])


@pytest.fixture
def turn(stage):
    """Begins to turn around before a table of some height with a can on it."""

    def run(table_m, can_m=0.55, edge_m=0.45):
        middle = poses.translation(edge_m + 0.3, 0.0, table_m - 0.02)
        top = SceneObject("table", Box((0.6, 1.2, 0.04)), middle, movable=False)
        can = SceneObject("red can", Cylinder(0.03, 0.11), poses.translation(can_m, -0.2, table_m + 0.055))
        stage.told.update(stage.told.scene.with_objects([top, can]))
        toolbox = dataclasses.replace(stage.toolbox, walking=FeetThatSetOut(), ranging=SeesNothingNear())
        leaf = ChangeViewpoint("turn around", toolbox, "around")
        stage.ready(leaf)
        return stage.tick(leaf), leaf.failure

    return run


def test_over_what_is_lower_than_the_hands_the_robot_turns(turn):
    status, _ = turn(0.80)

    assert status is Status.RUNNING


def test_where_the_hands_would_meet_what_stands_on_the_table_it_does_not(turn):
    status, failure = turn(0.99)

    assert status is Status.FAILURE
    assert failure.kind is FailureKind.INFEASIBLE  # a step back helps


def test_what_stands_farther_away_than_the_hands_reach_is_in_nobodys_way(turn):
    status, _ = turn(0.95, can_m=1.0)

    assert status is Status.RUNNING


def test_thighs_that_turn_do_not_press_against_a_table_that_the_range_sensor_looks_below(turn):
    status, failure = turn(0.80, edge_m=0.32)

    assert status is Status.FAILURE
    assert failure.kind is FailureKind.INFEASIBLE


def test_a_walk_that_was_stopped_has_failed_when_its_last_steps_are_made(stage):
    feet = FeetThatSetOut()
    toolbox = dataclasses.replace(stage.toolbox, walking=feet, ranging=SeesNothingNear())
    leaf = ChangeViewpoint("turn around", toolbox, "around")
    stage.ready(leaf)
    stage.tick(leaf)

    feet.handle.status = MotionStatus.REFUSED
    before = stage.tick(leaf)
    feet.active = False

    assert before is Status.RUNNING
    assert stage.tick(leaf) is Status.FAILURE
