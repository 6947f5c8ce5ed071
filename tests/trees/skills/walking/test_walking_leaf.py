"""A cup in the hand is no obstacle; what stands behind it is."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Cylinder
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from trees.skills.walking.walking_leaf import without_held


@pytest.mark.requirement("S2")
def test_points_of_a_held_cup_are_left_out_of_a_scan_and_others_are_not(stage):
    toolbox = stage.toolbox
    model = toolbox.model
    frame = model.description.tcp_frames["left"]
    cup = SceneObject("red cup", Cylinder(0.03, 0.11), np.eye(4))
    scene = PlanningScene().with_objects([cup]).with_attached("red cup", frame, np.eye(4), ())
    toolbox.world.update(scene)
    q = toolbox.sensing.state().q
    hand = poses.inverse(poses.translation(q[0], q[1], 0.0)) @ model.frame_pose(q, frame)
    x, y, z = hand[:3, 3]

    scan = without_held(toolbox, np.array([(x, y, z), (x, y, 0.1), (x + 0.4, y, z)]))

    np.testing.assert_allclose(scan, [(x, y, 0.1), (x + 0.4, y, z)])
