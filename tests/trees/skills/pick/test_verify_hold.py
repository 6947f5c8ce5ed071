from dataclasses import replace

import numpy as np
import pytest
from py_trees.common import Status

from kinematics.requests.grasp import Grasp
from robots.interface.gripper_reading import GripperReading
from robots.perception.object_estimate import ObjectEstimate
from robots.perception.position_error import alike_in_all_directions
from trees.events import NotSo
from trees.failures import FailureKind, Reason
from trees.skills.pick.verify_hold import VerifyHold, grip_failure

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


@pytest.fixture
def closed(knowing, planned, target):
    """The cup between the fingers, as wide as it is seen times a factor; told by a camera with its error."""

    planned.grip()

    def close(factor):
        error = alike_in_all_directions(0.003, 0.001, 0.01)
        seen = ObjectEstimate(
            "object", "cup", "red", target.odom_T_object, target.shape, 0.9, 8, 0.002, error=error
        )
        knowing.told.note_sightings({"red cup": seen})
        leaf = VerifyHold("verify hold", knowing.toolbox)
        grasp = replace(planned.grasp, diameter_m=factor * planned.grasp.diameter_m)
        return leaf, knowing.run(leaf, grasp=grasp, target=target)

    return close


@pytest.mark.requirement("P3")
def test_a_size_that_is_felt_twice_is_believed(closed):
    leaf, status = closed(4.0 / 3.0)
    assert status is Status.FAILURE
    assert leaf.failure.reason is Reason.FELT_OTHER_SIZE

    assert closed(4.0 / 3.0)[1] is Status.SUCCESS


@pytest.mark.requirement("P3")
@pytest.mark.parametrize(("factor", "told"), [(1.0, []), (1.15, [Reason.FELT_OTHER_SIZE])])
def test_a_size_that_is_a_little_off_is_told_and_goes_on(closed, knowing, factor, told):
    assert closed(factor)[1] is Status.SUCCESS
    assert [event.failure.reason for event in knowing.events if isinstance(event, NotSo)] == told
