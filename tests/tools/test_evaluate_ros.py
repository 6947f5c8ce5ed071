"""What the suites over the ROS door send and how they judge."""

import numpy as np
import pytest

pytest.importorskip("cyclonedds")

from executive.doors.ros.messages import Header, Twist, TwistStamped, Vector3
from tools.evaluate.ros.hostile_bytes import hostile, is_velocity
from tools.evaluate.ros.hostile_samples import growth_of


def stamped(twist):
    return TwistStamped(Header(frame_id="base_link"), twist)


@pytest.mark.parametrize(
    ("twist", "is_one"),
    [
        (Twist(Vector3(0.2), Vector3(z=-0.4)), True),
        (Twist(Vector3(1e-300)), True),
        (Twist(Vector3(3.0)), False),
        (Twist(Vector3(0.2, 0.1)), False),
        (Twist(Vector3(float("nan"))), False),
    ],
)
def test_a_velocity_that_somebody_may_mean_is_told_from_a_hostile_one(twist, is_one):
    assert is_velocity(Twist, twist.serialize()) is is_one
    assert is_velocity(TwistStamped, stamped(twist).serialize()) is is_one


def test_no_hostile_sample_is_a_velocity():
    rng = np.random.default_rng(5)

    for kind in (Twist, TwistStamped):
        assert not any(is_velocity(kind, hostile(kind, rng).serialize()) for _ in range(2000))


@pytest.mark.parametrize(
    ("kept_kb", "within"),
    [([100, 900, 1000, 1010, 1019], True), ([100, 900, 1000, 1021, 1000], False), ([1, 1, 1000, 979], False)],
)
def test_memory_is_judged_from_the_look_at_which_it_has_settled(kept_kb, within):
    assert growth_of(kept_kb)["within"] is within
