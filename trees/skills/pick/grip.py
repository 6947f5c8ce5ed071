"""What a gripper's reading says about the object that it should hold."""

from __future__ import annotations

from kinematics.requests.grasp import Grasp
from robots.interface.gripper_reading import GripperReading
from trees.failures import Failure


def grip_failure(reading: GripperReading, grasp: Grasp, opening_tolerance_m: float) -> Failure | None:
    """Why the reading contradicts that the hand holds the object of the grasp; None if it does not.

    "Holding" alone says that something resists; the opening says whether it has the size of the object.
    """
    if not reading.holding:
        return Failure.postcondition(
            "nothing between the fingers", opening_m=reading.opening_m, effort_nm=reading.effort_nm
        )
    if abs(reading.opening_m - grasp.diameter_m) > opening_tolerance_m:
        return Failure.postcondition(
            "something of another size is between the fingers",
            opening_m=reading.opening_m,
            expected_m=grasp.diameter_m,
            tolerance_m=opening_tolerance_m,
        )
    return None
