"""Where things truly are, as seen from the robot as it is drawn."""

import numpy as np
import pytest

from executive.doors.view.truth_drawing import true_places
from kinematics.geometry import poses


def test_a_thing_is_drawn_where_it_is_from_the_robot_wherever_the_robot_believes_to_be():
    rng = np.random.default_rng(5)
    for _ in range(20):
        turn_true, turn_drawn = (poses.rotation_from_vector(rng.normal(size=3)) for _ in range(2))
        world_T_base = poses.transform(turn_true, rng.normal(size=3))
        odom_T_base = poses.transform(turn_drawn, rng.normal(size=3))
        base_p = rng.normal(size=3)
        told = {
            "base": world_T_base.tolist(),
            "places_m": {"cup": (world_T_base @ [*base_p, 1.0])[:3].tolist()},
        }
        drawn = [*odom_T_base[:3, 3], *poses.quaternion_from_rotation(turn_drawn)]

        place = true_places(told, np.array(drawn))["cup"]
        assert place == pytest.approx((odom_T_base @ [*base_p, 1.0])[:3], abs=1e-9)
