"""Faults as values: written, read back, and refused when they are none."""

import pytest

from robots.scenes.planned_fault import VALUES, PlannedFault, fault_from_json
from robots.simulated.fault_plan import _ACTS


@pytest.mark.parametrize(
    "fault",
    [
        PlannedFault("joint_stuck", 1.5, "arm_left_4_joint"),
        PlannedFault("gyro_bias", 0.1, "", (0.1, 0.0, -0.2)),
        PlannedFault("object_moved", 2.0, "red cup", (0.05, -0.1)),
    ],
)
def test_a_fault_is_read_back_as_it_was_written(fault):
    assert fault_from_json(fault.to_json()) == fault


@pytest.mark.parametrize(
    ("given", "complaint"),
    [
        (("flood", 1.0), "no fault"),
        (("joint_weak", 1.0, "arm_left_4_joint"), "share"),
        (("joint_stuck", 1.0), "missing"),
        (("battery_low", 1.0, "red cup", (0.1,)), "too much"),
        (("joint_stuck", -1.0, "arm_left_4_joint"), "no times"),
        (("battery_low", 1.0, "", (float("nan"),)), "no times"),
    ],
)
def test_what_is_no_fault_is_refused(given, complaint):
    with pytest.raises(ValueError, match=complaint):
        PlannedFault(*given)


def test_every_kind_of_fault_can_be_brought_about():
    assert set(_ACTS) == set(VALUES)
