"""What fingers feel is compared with what a camera tells."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Cylinder
from robots.perception.fusion.gaussian import Gaussian
from robots.perception.fusion.hand_senses import compare_places, width_felt
from robots.perception.object_estimate import ObjectEstimate
from robots.perception.position_error import alike_in_all_directions

ERROR = alike_in_all_directions(0.005, 0.002, 0.01)
FELT = Gaussian(np.zeros(3), np.diag([0.025, 0.003, 0.035]) ** 2)
HAND = poses.transform(poses.rotation_z(0.7), (0.5, -0.2, 1.0))


def seen(tcp_place_m, error=ERROR):
    pose = HAND @ poses.translation(*tcp_place_m)
    return ObjectEstimate("object", "cup", "red", pose, Cylinder(0.03, 0.1), 0.9, 8, 0.003, error=error)


@pytest.mark.requirement("P3")
@pytest.mark.parametrize("share", [2.0 / 3.0, 4.0 / 3.0])
@pytest.mark.parametrize("width_m", [0.04, 0.06, 0.075])
def test_a_size_that_is_wrong_by_a_third_does_not_fit_the_opening(share, width_m):
    assert width_felt(width_m, share * width_m, 0.01).disagrees


@pytest.mark.parametrize("off_m", [-0.003, 0.0, 0.003])
def test_an_opening_within_the_error_fits(off_m):
    assert not width_felt(0.06 + off_m, 0.06, 0.01).disagrees


@pytest.mark.requirement("P3")
@pytest.mark.parametrize(("across_m", "differs"), [(0.005, False), (0.03, True), (-0.03, True)])
def test_a_thing_that_is_seen_beside_the_fingers_that_hold_it_is_noticed(across_m, differs):
    innovation = compare_places(FELT, seen((0.01, across_m, 0.0)), HAND, 1.0)

    assert innovation.disagrees is differs


@pytest.mark.requirement("P3")
def test_a_hand_that_is_rolled_feels_across_its_own_opening():
    rolled = HAND @ poses.transform(poses.rotation_x(1.0), (0.0, 0.0, 0.0))
    place = poses.inverse(rolled) @ HAND @ poses.translation(0.0, 0.0, 0.03)

    assert abs(place[1, 3]) > 0.02
    assert compare_places(FELT, seen((0.0, 0.0, 0.03)), rolled, 1.0).disagrees


def test_the_height_at_which_a_thing_is_held_is_no_disagreement():
    assert not compare_places(FELT, seen((0.0, 0.0, 0.2)), HAND, 1.0).disagrees


def test_a_detector_that_declares_no_error_cannot_be_contradicted():
    assert compare_places(FELT, seen((0.0, 0.03, 0.0), error=None), HAND, 1.0) is None
