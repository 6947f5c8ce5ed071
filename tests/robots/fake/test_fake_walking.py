"""The fake's feet step as they are told, stand between steps, and stop when they are told to."""

import numpy as np
import pytest

from kinematics.geometry.planar import PlanarPose
from kinematics.walking.pattern.steering import PathSteering
from robots.control.motion_handle import MotionStatus


@pytest.fixture
def walk(fake, model):
    settings = model.description.walking

    def to(x_m, yaw_rad=0.0):
        goal = PlanarPose(x_m, 0.0, yaw_rad)
        return fake.walking.walk(PathSteering(settings, (fake.motion.feet(), goal)), "walk")

    return to


def test_a_walk_ends_where_it_was_to_go_and_carries_the_body_along(fake, walk, play):
    over_feet = fake.motion.reference()[:2] - (fake.motion.feet().x_m, fake.motion.feet().y_m)

    handle = play(walk(1.0))

    feet = fake.motion.feet()
    assert handle.status is MotionStatus.DONE
    assert feet.x_m == pytest.approx(1.0, abs=0.02)
    np.testing.assert_allclose(fake.motion.reference()[:2] - (feet.x_m, feet.y_m), over_feet, atol=1e-6)


def test_a_cancelled_walk_stands_where_it_is(fake, walk):
    handle = walk(1.0)
    for _ in range(3):
        fake.step()

    fake.walking.cancel(handle, "enough")
    stood = fake.motion.feet()
    fake.step()

    assert handle.status is MotionStatus.CANCELED
    assert not fake.walking.active
    assert fake.motion.feet() == stood


def test_a_second_walk_is_refused_while_the_first_is_under_way(fake, walk):
    walk(1.0)
    fake.step()

    assert walk(0.5).status is MotionStatus.REFUSED
