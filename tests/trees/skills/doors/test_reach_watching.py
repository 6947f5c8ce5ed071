"""A hand on its way to a door stops when the door is seen to move."""

import numpy as np
import pytest
from py_trees.common import Status

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.scene.opening_path import DoorArc
from kinematics.scene.planning_scene import SceneObject
from robots.perception.truth_view import TrueObject
from robots.scenes.articulated import DOOR
from trees.beliefs.openings.handles import HandleTarget
from trees.failures import FailureKind
from trees.skills.doors.reach_watching import ReachWatching

PANEL, PLACE = Box((0.04, 0.6, 1.6)), poses.translation(1.4, 0.0, 1.3)
ARC = DoorArc(np.array([1.2, 0.5]), 0.0, 1.0, 0.55, 0.0, 1.0)
TARGET = HandleTarget(DOOR, "handle", "door", ARC, 0.0, ("left",))
ON_THE_WAY = 2


@pytest.fixture
def reaching(knowing, request):
    """The leaf under way, with a door in view and known; the way takes longer than two pictures."""
    knowing.fake.planning.motion_s = 0.4
    planned = request.getfixturevalue("planned")
    knowing.fake.world.put(TrueObject("door", "furniture", "door", None, PANEL, PLACE))
    knowing.told.update(knowing.told.scene.with_object(SceneObject("door", PANEL, PLACE, 0.015, False)))
    leaf = ReachWatching("reach", knowing.toolbox)
    version = knowing.told.scene.version
    checked = planned.checked("reach")
    knowing.ready(leaf, checked=type(checked)(checked.name, checked.checked, version), handle=TARGET)
    for _ in range(ON_THE_WAY):
        assert knowing.tick(leaf) is Status.RUNNING
    return leaf


def to_the_end(stage, leaf):
    for _ in range(2000):
        if stage.tick(leaf) is not Status.RUNNING:
            return leaf.status
    raise AssertionError("it never ended")


def test_before_a_door_that_stands_it_is_a_motion_like_any_other(knowing, reaching):
    assert to_the_end(knowing, reaching) is Status.SUCCESS


def test_a_door_that_swings_stops_the_hand(knowing, reaching):
    knowing.fake.world.move("door", (-0.04, 0.0, 0.0))

    assert to_the_end(knowing, reaching) is Status.FAILURE
    assert reaching.failure.kind is FailureKind.POSTCONDITION
    assert "the door moved while the hand was on its way" in reaching.failure.message
    assert reaching.failure.numbers["moved_m"] == pytest.approx(0.04, abs=0.01)
    assert not knowing.fake.motion.moving


def test_what_errors_of_sight_explain_stops_nothing(knowing, reaching):
    knowing.fake.world.move("door", (-0.015, 0.0, 0.0))

    assert to_the_end(knowing, reaching) is Status.SUCCESS


def test_one_wrong_picture_stops_nothing(knowing, reaching):
    knowing.fake.world.move("door", (-0.1, 0.0, 0.0))
    sequence = knowing.fake.detector.latest().sequence
    while knowing.fake.detector.latest().sequence == sequence:
        knowing.tick(reaching)
    knowing.fake.world.move("door", (0.1, 0.0, 0.0))

    assert to_the_end(knowing, reaching) is Status.SUCCESS


def test_a_door_that_is_out_of_sight_stops_nothing(knowing, reaching):
    knowing.fake.world.hidden.add("door")

    assert to_the_end(knowing, reaching) is Status.SUCCESS
