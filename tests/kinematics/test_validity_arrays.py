"""Arrays of the planner's judge are made once for a robot, and anew for another one."""

import dataclasses
import gc
import weakref

from kinematics.collision import leg_room, validity
from kinematics.model.robot_build import robot_build
from kinematics.model.robot_model import RobotModel
from robots.models.description import load_description

TALOS = load_description("talos")


def arrays(model):
    return robot_build(model).derived(validity._arrays)


def hand_arrays(model, hand):
    return robot_build(model).derived(validity._hand_arrays, hand)


def test_two_models_of_one_robot_share_their_arrays():
    first, again = RobotModel(TALOS), RobotModel(load_description("talos"))

    assert arrays(first) is arrays(again)
    assert hand_arrays(first, "left") is hand_arrays(again, "left")
    assert hand_arrays(first, "left") is not hand_arrays(first, "right")


def test_two_models_of_one_robot_share_the_arrays_of_their_legs():
    first, again = (robot_build(RobotModel(load_description("talos"))) for _ in range(2))

    assert first.derived(leg_room._leg_arrays) is again.derived(leg_room._leg_arrays)


def test_what_is_carried_makes_another_robot():
    model = RobotModel(TALOS)

    assert arrays(model.carrying({"left": 2.0})) is not arrays(model)


def test_another_pair_that_may_touch_makes_another_robot():
    other = RobotModel(dataclasses.replace(TALOS, disabled_collisions=frozenset()))

    assert arrays(other) is not arrays(RobotModel(TALOS))


def test_what_is_shared_keeps_no_model_that_somebody_has_put_away():
    model = RobotModel(dataclasses.replace(TALOS, groups={**TALOS.groups, "of_this_test": TALOS.joints[:1]}))
    shared, alive = arrays(model), weakref.ref(model)
    del model
    gc.collect()

    assert alive() is None
    assert shared is not None
