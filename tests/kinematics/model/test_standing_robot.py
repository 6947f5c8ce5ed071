import dataclasses

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.model.derived import Recent
from kinematics.model.stance import Stance
from kinematics.model.standing_robot import StandingRobot
from kinematics.standing.free_coordinates import free_coordinates


def moved(stance, x_m):
    return Stance(tuple((frame, poses.translation(x_m, 0.0, 0.0) @ pose) for frame, pose in stance.soles))


def test_equal_stances_of_a_model_give_one_value(talos, stance):
    again = Stance(stance.soles)

    assert StandingRobot.of(talos, again) is StandingRobot.of(talos, stance)


def test_what_was_made_of_a_standing_robot_is_made_once(talos, stance):
    robot = StandingRobot(talos, stance)

    assert free_coordinates(robot) is free_coordinates(robot)


def test_another_stance_has_free_coordinates_of_its_own(talos, stance):
    here, there = StandingRobot.of(talos, stance), StandingRobot.of(talos, moved(stance, 0.5))

    np.testing.assert_allclose(free_coordinates(there).home[0] - free_coordinates(here).home[0], 0.5)


def test_a_robot_that_carries_something_shares_nothing_with_the_one_that_does_not(talos, stance):
    loaded = talos.carrying({"left": 2.0})

    assert StandingRobot.of(loaded, stance) is not StandingRobot.of(talos, stance)


def test_a_holder_cannot_change_where_it_stands(talos, stance):
    robot = StandingRobot(talos, stance)

    with pytest.raises(dataclasses.FrozenInstanceError):
        robot.stance = moved(stance, 0.5)


def test_a_holder_cannot_change_the_home_posture_of_others(talos, stance):
    robot = StandingRobot(talos, stance)

    robot.q_home[:] = 0.0

    assert np.abs(robot.q_home).max() > 0.1


def test_old_stances_are_forgotten(talos, stance):
    first = StandingRobot.of(talos, stance)

    for k in range(1, 20):
        StandingRobot.of(talos, moved(stance, 0.01 * k))

    assert StandingRobot.of(talos, stance) is not first


def test_what_is_asked_for_again_is_kept_longer_than_what_is_not():
    made = []
    recent = Recent(2)

    for key in ("a", "b", "a", "c", "a", "b"):
        recent.of(key, lambda key=key: made.append(key))

    assert made == ["a", "b", "c", "b"]
