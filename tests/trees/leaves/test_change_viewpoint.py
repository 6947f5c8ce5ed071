"""Who turns on the spot swings the hands around, over a table and whatever stands on it."""

import dataclasses

import numpy as np
import pytest
from py_trees.common import Status

from kinematics import poses
from kinematics.scene import SceneObject
from kinematics.shapes import Box, Cylinder
from robots.control.motion_handle import MotionHandle
from trees.failures import FailureKind
from trees.leaves.change_viewpoint import ChangeViewpoint


class FeetThatSetOut:
    """Walking that never arrives."""

    active = False

    def walk(self, steering, name):
        return MotionHandle(name, "feet")


class SeesNothingNear:
    """A range sensor under which everything passes."""

    def scan(self):
        return np.array([[2.0, 0.0, 0.5]])


@pytest.fixture
def turn(stage):
    """Begins to turn around before a table of some height with a can on it."""

    def run(table_m, can_m=0.45):
        top = SceneObject(
            "table", Box((0.6, 1.2, 0.04)), poses.translation(0.65, 0.0, table_m - 0.02), movable=False
        )
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
    status, _ = turn(0.95, can_m=0.93)

    assert status is Status.RUNNING
