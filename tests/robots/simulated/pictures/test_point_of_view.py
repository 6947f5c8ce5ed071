"""From which side pictures are taken."""

import math

import numpy as np
import pytest

from robots.scenes.scene_file import load_scene
from robots.simulated.pictures.point_of_view import clearest_view

LOOKAT = np.array([0.25, 0.0, 0.88])


@pytest.mark.parametrize("opening_rad", [0.0, 1.2])
def test_a_fridge_is_shown_from_the_side_that_opens(stand, opening_rad):
    body = stand(load_scene("fridge"))
    body.world.faults.set_opening("fridge", opening_rad)

    turn, distance_m = clearest_view(body.world, LOOKAT, math.radians(-14.0), 4.0 / 3.0)

    (piece,) = body.world.physics.scene.furniture
    inwards = np.array([math.cos(piece.yaw_rad), math.sin(piece.yaw_rad)])
    eye = LOOKAT[:2] - distance_m * math.cos(math.radians(14.0)) * np.array([math.cos(turn), math.sin(turn)])
    assert (eye - piece.position_m) @ inwards < -0.5 * piece.size_m[0]
