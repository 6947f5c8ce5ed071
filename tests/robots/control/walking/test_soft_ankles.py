"""Ankles that give way: the servo's stiffness less what is taken away is the soft one."""

import dataclasses

import numpy as np
import pytest

from kinematics.model.robot_model import RobotModel
from robots.control.walking.soft_ankles import SoftAnkles
from robots.models.description import load_description, load_robot
from tools.evaluate.disturbed.rough import run_rough_episode
from tools.evaluate.orders import EpisodeOrder

TALOS = RobotModel(load_description("talos"))
HARDWARE = load_robot("talos").hardware
SETTINGS = HARDWARE.walking
ANKLE = TALOS.joint_index("leg_left_5_joint")
KNEE = TALOS.joint_index("leg_left_4_joint")
AWAY_RAD = 0.01


def efforts(soft_for_s, away_rad_s=0.0):
    ankles = SoftAnkles(TALOS, HARDWARE.gains, SETTINGS)
    still = np.zeros(len(TALOS.joints))
    felt = still.copy(), still.copy()
    for joint in (ANKLE, KNEE):
        felt[0][joint], felt[1][joint] = -AWAY_RAD, -away_rad_s
    for _ in range(round(soft_for_s / 0.002)):
        found = ankles.efforts((still, still), felt, True, 0.002)
    return found


def test_what_is_left_of_the_servo_is_as_soft_as_is_wanted():
    servo = HARDWARE.gains["leg_left_5_joint"].stiffness * AWAY_RAD

    assert servo + efforts(0.5)[ANKLE] == pytest.approx(SETTINGS.ankle_stiffness_nm * AWAY_RAD)


def test_its_damping_is_softer_too():
    gains = HARDWARE.gains["leg_left_5_joint"]
    servo = gains.stiffness * AWAY_RAD + gains.damping * 0.2

    left = SETTINGS.ankle_stiffness_nm * AWAY_RAD + SETTINGS.ankle_damping_nms * 0.2
    assert servo + efforts(0.5, 0.2)[ANKLE] == pytest.approx(left)


def test_no_other_joint_is_touched():
    assert efforts(0.5)[KNEE] == 0.0


def test_it_begins_by_and_by():
    assert abs(efforts(0.03)[ANKLE]) < 0.15 * abs(efforts(0.5)[ANKLE])


@pytest.mark.requirement("M6")
def test_it_walks_over_scattered_plates_on_which_stiff_ankles_let_it_fall():
    record = run_rough_episode(EpisodeOrder(17))

    assert record.numbers["wrong"] == "uneven"
    assert record.truth


def test_a_robot_whose_ankles_stay_stiff_has_nothing_taken_away():
    gains = HARDWARE.gains["leg_left_5_joint"]
    stiff = dataclasses.replace(SETTINGS, ankle_stiffness_nm=gains.stiffness, ankle_damping_nms=gains.damping)
    ankles = SoftAnkles(TALOS, HARDWARE.gains, stiff)
    told = np.zeros(len(TALOS.joints))

    for _ in range(200):
        found = ankles.efforts((told, told), (told - 0.01, told - 0.1), True, 0.002)

    assert not found.any()
