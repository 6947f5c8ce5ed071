"""Rooms of the map, where the robot believes them to be."""

import numpy as np
import pytest

from executive.doors.view.map_drawing import corners_of
from executive.live.world_as_json import rooms_json
from robots.scenes.scene_description import Region


def test_a_room_is_drawn_where_it_is_and_as_it_is_turned():
    rng = np.random.default_rng(4)
    for _ in range(20):
        middle, size, yaw = rng.normal(size=2), rng.uniform(1.0, 5.0, 2), rng.uniform(-3.0, 3.0)
        region = Region("kitchen", tuple(middle), tuple(size), float(yaw))
        (room,) = rooms_json({"kitchen": region})

        corners = corners_of(room)
        assert corners.mean(axis=0) == pytest.approx(middle, abs=1e-3)
        for x, y in middle + 0.98 * (corners - middle):
            assert region.contains(x, y)
        for x, y in middle + 1.02 * (corners - middle):
            assert not region.contains(x, y)
