import numpy as np
import pytest

from kinematics.requests.grasp import Grasp
from robots.interface.gripper_reading import GripperReading
from trees.failures import FailureKind, Reason
from trees.skills.pick.verify_hold import grip_failure

GRASP = Grasp("left", "side", np.eye(4), 0.1, diameter_m=0.06)


def reading(opening_m, holding=True):
    return GripperReading("left", -0.2, opening_m, 3.5 if holding else 0.0, holding)


def test_an_opening_of_the_objects_size_with_effort_is_a_grip():
    assert grip_failure(reading(0.063), GRASP, 0.012) is None


@pytest.mark.requirement("M2")
def test_an_opening_without_effort_is_no_grip():
    failure = grip_failure(reading(0.06, holding=False), GRASP, 0.012)

    assert failure.kind is FailureKind.POSTCONDITION
    assert failure.message == "nothing between the fingers"
    assert failure.reason is Reason.CLOSED_ON_NOTHING


@pytest.mark.requirement("M2")
@pytest.mark.parametrize("opening_m", [0.03, 0.085])
def test_effort_at_another_opening_is_something_else(opening_m):
    failure = grip_failure(reading(opening_m), GRASP, 0.012)

    assert failure.numbers["expected_m"] == 0.06
    assert failure.numbers["opening_m"] == opening_m
