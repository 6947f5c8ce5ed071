"""A trunk that aims tilts what a hand holds: it bends by no more than that may lean."""

from types import SimpleNamespace

import pytest

from robots.models.description import load_description
from trees.policy import TreePolicy
from trees.skills.looking.aiming_leaf import level_enough
from trees.skills.looking.look_at import joints_of


def with_in_hand(robot, attached):
    world = SimpleNamespace(scene=SimpleNamespace(attached=attached))
    return SimpleNamespace(model=SimpleNamespace(description=load_description(robot)), world=world)


@pytest.mark.parametrize("gaze", TreePolicy().level_gazes)
def test_with_something_in_hand_a_trunk_turns_and_hardly_bends(gaze):
    joints = joints_of(gaze, load_description("g1"))

    empty, holding = (level_enough(with_in_hand("g1", held), joints) for held in ({}, {"cup": object()}))

    assert empty == joints
    assert empty["waist_pitch_joint"] < -0.3
    assert abs(holding["waist_pitch_joint"]) <= 0.12
    assert holding["waist_yaw_joint"] == joints["waist_yaw_joint"]


def test_a_neck_moves_nothing_that_is_held():
    joints = joints_of(TreePolicy().level_gazes[0], load_description("talos"))

    assert level_enough(with_in_hand("talos", {"cup": object()}), joints) == joints
