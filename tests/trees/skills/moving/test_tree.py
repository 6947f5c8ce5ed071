"""A turn on the spot right before something tall: a step away comes first."""

import dataclasses
import math

import numpy as np
import pytest
from py_trees.blackboard import Blackboard

from kinematics.geometry.planar import PlanarPose
from kinematics.walking.pattern.steering import StretchSteering, TurnSteering
from robots.control.motion_handle import MotionHandle, MotionStatus
from trees.build import build_tree
from trees.tasks import MoveTask

TURN = MoveTask("turn left", 0.0, 0.5, 2.5)
AHEAD, AROUND = [(0.66, 0.0, 1.2)], [(0.66, 0.0, 1.2), (-0.4, 0.0, 1.2)]


class Feet:
    """Does at once what is asked of it, and has room to turn after a step.

    Attributes:
        share: How much of each step comes about; soles may slip.
    """

    def __init__(self, motion):
        self.done, self.points = [], np.empty((0, 3))
        self.active, self.share = False, 1.0
        self._motion = motion

    def scan(self):
        return self.points

    def walk(self, steering, name):
        self.done.append(steering)
        handle = MotionHandle(name, f"walk-{len(self.done)}")
        handle.status, before = MotionStatus.DONE, PlanarPose()
        for _ in range(20):
            step = steering.advance(self._motion.feet(), before)
            if step is None:
                break
            before = step
            self._motion.step_by(PlanarPose(step.x_m, step.y_m, self.share * step.yaw_rad))
        if isinstance(steering, StretchSteering):
            self.points = self.points - (math.copysign(steering.distance_m, steering.linear_m_s), 0.0, 0.0)
        return handle


@pytest.fixture
def turned(stage_with):
    """How a turn to the left ends, and which ways the feet went."""

    def run(points, task=TURN, slips=1.0):
        stage = stage_with()
        feet = Feet(stage.fake.motion)
        feet.share = slips
        feet.points = np.array(points, dtype=float).reshape(-1, 3)
        stage.toolbox = dataclasses.replace(stage.toolbox, walking=feet, ranging=feet)
        tree = stage.play(build_tree(task, stage.toolbox))
        return tree, feet.done

    yield run
    Blackboard.clear()


def test_a_step_back_comes_before_a_turn_that_has_no_room(turned):
    tree, ways = turned(AHEAD)

    assert tree.status == "success"
    assert [type(way) for way in ways] == [StretchSteering, TurnSteering]
    assert ways[0].linear_m_s < 0.0


def test_where_there_is_room_it_turns_at_once(turned):
    tree, ways = turned([(1.5, 0.0, 1.2)])

    assert tree.status == "success"
    assert [type(way) for way in ways] == [TurnSteering]


def test_between_things_that_leave_no_way_it_does_not_move_at_all(turned):
    tree, ways = turned(AROUND)

    assert tree.status == "failure"
    assert "no room to turn for the hands" in str(tree.failure)
    assert not ways


@pytest.mark.requirement("M2", "M6")
@pytest.mark.parametrize("angle_rad", [math.radians(10.0), math.radians(-45.0), 2.5])
def test_a_turn_ends_where_it_was_to_end(turned, angle_rad):
    task = MoveTask("turn", 0.0, math.copysign(0.5, angle_rad), abs(angle_rad) / 0.5)

    tree, ways = turned([], task)

    assert tree.status == "success"
    assert tree.evidence["turned_rad"] == pytest.approx(angle_rad, abs=0.035)
    assert len(ways) == 1


@pytest.mark.requirement("M2", "M6")
def test_a_turn_that_soles_slip_in_is_gone_on_with_and_one_that_does_not_come_about_is_not_claimed(turned):
    tree, ways = turned([], slips=0.0)

    assert tree.status == "failure"
    assert tree.failure.root.message == "it turned by 0 degrees, not by 72"
    assert len(ways) == 3
