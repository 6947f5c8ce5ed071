"""A turn on the spot right before something tall: a step away comes first."""

import dataclasses
import math

import numpy as np
import pytest
from py_trees.blackboard import Blackboard

from kinematics.walking.steering import StretchSteering, VelocitySteering
from robots.control.motion_handle import MotionHandle, MotionStatus
from trees.build import build_tree
from trees.tasks import MoveTask

AHEAD, AROUND = [(0.66, 0.0, 1.2)], [(0.66, 0.0, 1.2), (-0.4, 0.0, 1.2)]


class Feet:
    """Does at once what is asked of it, and has room to turn after a step."""

    def __init__(self):
        self.done, self.points = [], np.empty((0, 3))
        self.active = False

    def scan(self):
        return self.points

    def walk(self, steering, name):
        self.done.append(steering)
        handle = MotionHandle(name, f"walk-{len(self.done)}")
        handle.status = MotionStatus.DONE
        if isinstance(steering, StretchSteering):
            self.points = self.points - (math.copysign(steering.distance_m, steering.linear_m_s), 0.0, 0.0)
        return handle


@pytest.fixture
def turned(stage_with):
    """How a turn to the left ends, and which ways the feet went."""

    def run(points):
        stage, feet = stage_with(), Feet()
        feet.points = np.array(points, dtype=float).reshape(-1, 3)
        stage.toolbox = dataclasses.replace(stage.toolbox, walking=feet, ranging=feet)
        tree = stage.play(build_tree(MoveTask("turn left", 0.0, 0.5, 2.5), stage.toolbox))
        return tree, feet.done

    yield run
    Blackboard.clear()


def test_a_step_back_comes_before_a_turn_that_has_no_room(turned):
    tree, ways = turned(AHEAD)

    assert tree.status == "success"
    assert [type(way) for way in ways] == [StretchSteering, VelocitySteering]
    assert ways[0].linear_m_s < 0.0


def test_where_there_is_room_it_turns_at_once(turned):
    tree, ways = turned([(1.5, 0.0, 1.2)])

    assert tree.status == "success"
    assert [type(way) for way in ways] == [VelocitySteering]


def test_between_things_that_leave_no_way_it_does_not_move_at_all(turned):
    tree, ways = turned(AROUND)

    assert tree.status == "failure"
    assert "no room to turn for the hands" in str(tree.failure)
    assert not ways
