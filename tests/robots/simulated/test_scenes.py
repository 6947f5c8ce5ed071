"""The scenes of a household, as worlds: nothing creeps, tips, sinks or rolls away."""

import math

import numpy as np
import pytest

from kinematics import poses
from robots.scene_file import load_scene

STILL_M = 0.001
UPRIGHT_RAD = math.radians(0.5)


@pytest.mark.parametrize("name", ["shelf", "counter", "dinner"])
def test_everything_stands_as_the_scene_says_for_ten_seconds(stand, name):
    scene = load_scene(name)
    body = stand(scene)

    body.run(10.0)

    assert not body.truth.fallen()
    for item in scene.objects:
        moved = body.truth.world_T_object(item.name)[:3, 3] - item.world_T_object[:3, 3]
        assert np.linalg.norm(moved) < STILL_M, item.name
        assert body.truth.tilt_rad(item.name) < UPRIGHT_RAD, item.name


def test_the_lift_of_an_object_counts_from_the_board_that_it_is_over(stand):
    body = stand(load_scene("shelf"))
    assert body.truth.lift_m("red cup") == pytest.approx(0.0, abs=1e-3)

    lifted = body.truth.world_T_object("red cup") @ poses.translation(0.0, 0.0, 0.05)
    body.world.faults.teleport("red cup", lifted)

    assert body.truth.lift_m("red cup") == pytest.approx(0.05, abs=1e-3)
