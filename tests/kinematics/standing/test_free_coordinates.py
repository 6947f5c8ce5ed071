import numpy as np
import pytest

from kinematics.model.standing_robot import StandingRobot
from kinematics.standing.free_coordinates import free_coordinates


def test_many_configurations_have_the_coordinates_of_each(talos, stance):
    space = free_coordinates(StandingRobot(talos, stance))
    rng = np.random.default_rng(2)
    x = space.home + rng.uniform(-0.2, 0.2, (12, space.size))
    x[0, 3:6] = 0.0
    q = space.to_q(x)[0]
    q[5, 3:7] *= -1.0  # the same rotation

    many = space.from_many(q)

    assert many == pytest.approx(np.array([space.from_q(row) for row in q]), abs=1e-12)
    assert many == pytest.approx(x, abs=1e-9)
