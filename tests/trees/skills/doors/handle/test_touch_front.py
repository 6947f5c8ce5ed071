"""From a hand at a front to one that pushes it."""

import numpy as np
from py_trees.common import Status

from kinematics.requests.grasp import Grasp
from kinematics.scene.opening_path import DoorArc
from robots.control.hands.yield_settings import YieldReport
from trees.beliefs.openings.handles import HandleTarget
from trees.skills.doors.handle.touch_front import TouchFront


def test_a_push_is_felt_from_what_was_read_before_the_hand_met_the_front(stage):
    arc = DoorArc(np.array([0.8, 0.75]), 0.0, 1.0, 0.5, 0.05, 1.0)
    target = HandleTarget("door", "door", "door", arc, 0.6, ("left",), pushed=True)
    bias = np.arange(6.0)
    leaf = TouchFront("touch front", stage.toolbox)

    stage.run(
        leaf,
        handle=target,
        grasp=Grasp("left", "push", np.eye(4), 0.07, 0.0),
        approached=YieldReport("arrived", 0.0, 8.0, 8.0, bias),
    )

    assert leaf.status is Status.SUCCESS
    np.testing.assert_array_equal(stage.output("held").bias, bias)
