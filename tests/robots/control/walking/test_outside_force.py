"""What holds a walking body back is told from what its soles do, and from pushes of a moment."""

import math

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from robots.control.gate.refusal import Limit
from robots.control.walking.outside_force import OutsideForce

PERIOD_S = 0.002
MASS_KG = 90.0


def walked(outside_n, seconds=2.0, yaw_rad=0.0, soles_n=lambda _t: 60.0, leaning_rad=0.0, error_n=0.0):
    """What is told while the soles push and something else pushes as well; the CoM moves as both say."""
    watch = OutsideForce(MASS_KG, ("left", "right"), PERIOD_S, error_n)
    feet = {"left": PlanarPose(0.0, 0.1, yaw_rad), "right": PlanarPose(0.0, -0.1, yaw_rad)}
    leaning = poses.rotation_y(leaning_rad)
    speed, told = 0.0, []
    for k in range(round(seconds / PERIOD_S)):
        t_s = k * PERIOD_S
        sole_n = soles_n(t_s)
        speed += PERIOD_S * (sole_n + outside_n(t_s)) / MASS_KG
        wrench = np.zeros((2, 6))
        wrench[k // 250 % 2, :3] = leaning.T @ (sole_n, 0.0, 9.81 * MASS_KG)
        velocity = (speed * math.cos(yaw_rad), speed * math.sin(yaw_rad))
        told.append(watch.feel(wrench, feet, lambda _side: leaning, velocity))
    return [one for one in told if one is not None]


def test_soles_that_push_hard_and_carry_the_body_along_are_nothing_from_outside():
    assert walked(lambda _t: 0.0, soles_n=lambda t: 200.0 * math.sin(5.0 * t)) == []


@pytest.mark.parametrize("yaw_rad", [0.0, 2.0])
def test_what_goes_on_holding_the_body_back_is_told_within_a_step(yaw_rad):
    told = walked(lambda t: -150.0 if t > 1.0 else 0.0, seconds=1.0 + 0.6, yaw_rad=yaw_rad)

    assert told
    assert told[-1].limit is Limit.FORCE
    assert told[-1].value > 80.0
    assert str(told[-1]).startswith("unexpected force of something on the body: ")


@pytest.mark.parametrize("began_s", [1.0, 1.05, 1.23])
def test_a_push_of_a_tenth_of_a_second_is_not_taken_for_something_that_was_met(began_s):
    assert walked(lambda t: 400.0 if began_s <= t < began_s + 0.1 else 0.0) == []


def test_soles_that_lean_on_the_edge_of_a_plate_take_no_weight_for_a_push():
    assert walked(lambda _t: 0.0, leaning_rad=0.15) == []


def test_a_weight_on_somebodys_hand_may_pull_a_little():
    assert walked(lambda _t: -60.0) == []


def test_what_the_soles_are_only_estimated_to_do_has_to_be_exceeded_by_their_error():
    assert walked(lambda _t: -90.0)
    assert walked(lambda _t: -90.0, error_n=15.0) == []
    assert walked(lambda _t: -100.0, error_n=15.0)
