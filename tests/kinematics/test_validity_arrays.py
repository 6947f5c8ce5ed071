"""Arrays of the planner's judge are made once for a robot, and anew for another one."""

import dataclasses

from kinematics.collision import leg_room, validity
from kinematics.model.robot_build import robot_build
from kinematics.model.robot_model import RobotModel
from robots.models.description import load_description

TALOS = load_description("talos")


def test_two_models_of_one_robot_share_their_arrays():
    first, again = RobotModel(TALOS), RobotModel(load_description("talos"))

    assert validity._arrays(first) is validity._arrays(again)
    assert validity._hand_arrays(first, "left") is validity._hand_arrays(again, "left")
    assert validity._hand_arrays(first, "left") is not validity._hand_arrays(first, "right")


def test_two_models_of_one_robot_share_the_arrays_of_their_legs():
    first, again = (robot_build(RobotModel(load_description("talos"))) for _ in range(2))

    assert leg_room._leg_arrays(first) is leg_room._leg_arrays(again)


def test_what_is_carried_makes_another_robot():
    model = RobotModel(TALOS)

    assert validity._arrays(model.carrying({"left": 2.0})) is not validity._arrays(model)


def test_another_pair_that_may_touch_makes_another_robot():
    other = RobotModel(dataclasses.replace(TALOS, disabled_collisions=frozenset()))

    assert validity._arrays(other) is not validity._arrays(RobotModel(TALOS))
