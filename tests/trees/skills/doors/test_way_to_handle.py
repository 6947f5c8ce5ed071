"""The way to a handle is walked as any other, and does not go aside for people in a room."""

import numpy as np

from kinematics.scene.opening_path import DrawerLine
from trees.beliefs.openings.handles import HandleTarget
from trees.skills.doors.handle_standing import WalkToHandle


def test_new_points_on_the_way_to_a_handle_do_not_change_where_it_goes(stage):
    line = DrawerLine(np.array([2.0, 0.0, 0.9]), 0.0)
    target = HandleTarget("drawer", "handle", "drawer", line, 0.0, ("left", "right"))
    leaf = stage.ready(WalkToHandle("walk", stage.toolbox), handle=target)
    leaf.begin()

    assert leaf._goes_elsewhere() is False
