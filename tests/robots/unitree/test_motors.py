"""Which motor is which joint."""

import pytest

from robots.errors import DescriptionError
from robots.unitree.motors import motors_of


def test_every_joint_of_a_g1_has_a_motor_of_its_own(g1):
    motors = motors_of(g1.description.joints)

    assert sorted(motors.tolist()) == list(range(29))


@pytest.mark.parametrize(
    ("joint", "motor"),
    [
        ("left_knee_joint", 3),
        ("right_ankle_roll_joint", 11),
        ("waist_pitch_joint", 14),
        ("right_elbow_joint", 25),
    ],
)
def test_motors_are_counted_as_the_maker_counts_them(joint, motor):
    assert motors_of([joint]).tolist() == [motor]


def test_a_joint_without_a_motor_is_named():
    with pytest.raises(DescriptionError, match="'tail_joint' has no motor"):
        motors_of(["left_knee_joint", "tail_joint"])
