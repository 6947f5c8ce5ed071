"""Who took something is looked at so that one picture shows crown and hand."""

import numpy as np
import pytest
from py_trees.common import Status

from kinematics.geometry import poses
from robots.fake.fake_world import cup, person
from tests.trees.leaf_inputs import believe
from trees.beliefs.grounding.destination import Place
from trees.beliefs.scene.held_object import HeldObject
from trees.beliefs.sight.sight import off_axis_rad
from trees.policy import Gaze
from trees.port_values import Placement
from trees.skills.hand_over.look_at_taker import LookAtTaker
from trees.skills.looking.look_at import LookAt

BELOW = Gaze("below", tilt_rad=0.77, lean_rad=0.45)
"""As after a look at where the thing was let go, with a trunk that leans over it."""


@pytest.mark.requirement("M3")
@pytest.mark.parametrize("far_m", [1.6, 2.1])
@pytest.mark.parametrize("drawn_back", [0.3, 0.5, 0.7])
def test_crown_and_what_is_held_are_in_the_picture_also_after_a_look_below(stage, far_m, drawn_back):
    ana, red = person("Ana", (far_m, 0.2)), cup()
    believe(stage, [ana])
    let_go = poses.translation(0.65, 0.1, 1.05)
    inputs = {
        "place": Place("Ana", "person", ana.shape, ana.world_T_object, 0.9),
        "held": HeldObject(red.name, "left", red.shape, np.eye(4)),
        "placement": Placement("left", let_go, (), (0.65, 0.1)),
    }
    assert stage.run(LookAt("below", stage.toolbox, BELOW)) is Status.SUCCESS

    assert stage.run(LookAtTaker("look", stage.toolbox), **inputs) is Status.SUCCESS

    camera = stage.toolbox.model.description.camera
    crown = ana.world_T_object[:3, 3] + (0.0, 0.0, 0.5 * ana.shape.height_m)
    hand = let_go[:3, 3] + drawn_back * (ana.world_T_object[:3, 3] - let_go[:3, 3]) * (1.0, 1.0, 0.0)
    for end in (crown, hand - (0.0, 0.0, 0.5 * red.shape.height_m)):
        across, down = off_axis_rad(stage.fake.world.world_T_camera(), end)
        assert abs(across) < 0.5 * camera.horizontal_fov_rad
        assert abs(down) < 0.5 * camera.vertical_fov_rad
