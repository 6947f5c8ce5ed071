"""One folder holds all that is known of a robot: planners get its geometry, the control loop the rest."""

import dataclasses

import pytest

from kinematics.model.robot_description import GripperDescription, RobotDescription
from kinematics.model.walking_settings import WalkingSettings
from robots.interface.hardware import GripSettings, Hardware, WalkingGains
from robots.models.description import load_robot
from robots.outside import known_robots


def names(kind):
    return {field.name for field in dataclasses.fields(kind)}


def test_what_planners_know_of_a_robot_says_nothing_of_its_servos_and_sensors():
    assert names(RobotDescription).isdisjoint(names(Hardware) - {"walking"})
    assert names(GripperDescription).isdisjoint(names(GripSettings))
    assert names(WalkingSettings).isdisjoint(names(WalkingGains))


@pytest.mark.parametrize("name", known_robots())
def test_every_joint_of_a_setpoint_has_a_servo_and_every_gripper_a_grip(name):
    robot = load_robot(name)

    assert set(robot.hardware.gains) == set(robot.description.actuated)
    assert set(robot.hardware.grips) == set(robot.description.grippers)
    assert (robot.hardware.walking is None) == (robot.description.walking is None)


def test_numbers_of_a_kind_are_those_of_its_joints():
    hardware = load_robot("talos").hardware

    assert hardware.gains["arm_left_4_joint"].stiffness == 2000.0
    assert hardware.contact_effort_nm["arm_left_4_joint"] == 10.0
    assert "leg_left_1_joint" not in hardware.contact_effort_nm
    assert set(hardware.walking.joint_acceleration) == {
        f"leg_{side}_{number}_joint" for side in ("left", "right") for number in range(1, 7)
    }
