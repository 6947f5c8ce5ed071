"""Looking at where something was put."""

import math

import numpy as np
import pytest
from py_trees.common import Status

from kinematics.geometry import poses
from kinematics.geometry.shapes import Cylinder
from trees.beliefs.scene.held_object import HeldObject
from trees.beliefs.sight.sight import off_axis_rad
from trees.port_values import Placement
from trees.skills.carrying.look_at_placement import LookAtPlacement

CUP = HeldObject("red cup", "left", Cylinder(0.03, 0.11), np.eye(4))


def placed_at(x, y, z):
    return Placement("left", poses.translation(x, y, z), ("table",), (x, y))


def lean_rad(stage):
    return stage.fake.sensing.state().q[7 + stage.toolbox.model.joint_index("torso_2_joint")]


@pytest.mark.parametrize(("ahead_m", "leans"), [(0.8, False), (0.40, True), (0.38, True)])
def test_what_stands_at_the_near_edge_is_looked_at_with_the_trunk_too(stage, ahead_m, leans):
    placement = placed_at(ahead_m, 0.04, 0.92)

    assert stage.run(LookAtPlacement("look", stage.toolbox), held=CUP, placement=placement) is Status.SUCCESS

    off = off_axis_rad(stage.fake.world.world_T_camera(), placement.odom_T_object[:3, 3])
    assert math.hypot(*off) < 0.26
    assert (lean_rad(stage) > 0.05) == leans
