"""When the robot has left the place where it began."""

import pytest

from executive.errands.away_from_start import is_away, leads_away
from kinematics.geometry.planar import PlanarPose
from trees.tasks import MoveTask


@pytest.mark.parametrize(
    ("x_m", "yaw_rad", "away"),
    [(0.0, 0.0, False), (0.2, 0.3, False), (0.0, 3.1, True), (0.0, -1.0, True), (-0.7, 0.0, True)],
)
def test_a_robot_that_turned_or_went_has_left(x_m, yaw_rad, away):
    assert is_away(PlanarPose(x_m, 0.1, yaw_rad)) == away


@pytest.mark.parametrize(
    ("move", "leads"),
    [
        (MoveTask("turn around", 0.0, 0.5, 6.28), True),
        (MoveTask("turn right a little", 0.0, -0.5, 0.6), False),
        (MoveTask("step back", -0.3, 0.0, 1.0), False),
        (MoveTask("go back", -0.3, 0.0, 4.0), True),
        (MoveTask("two steps", 0.3, 0.0, None, 0.4), False),
        (MoveTask("a metre ahead", 0.3, 0.0, None, 1.0), True),
        (MoveTask("turn left", 0.0, 0.5), True),
        (MoveTask("stand", 0.0, 0.0), False),
    ],
)
def test_a_velocity_that_turns_or_goes_far_leads_away(move, leads):
    assert leads_away(move) == leads
