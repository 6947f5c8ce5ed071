"""Buttons are asked for where the robot that is asked can have its hands."""

import math

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.model.robot_model import RobotModel
from robots.models.description import load_description
from tools.evaluate.skills.episode import trial_of

SEEDS = range(30)


def buttons_m(trial):
    """Where the buttons are, in the world."""
    found = []
    for piece in trial.scene.furniture:
        for button in piece.controls:
            x, y, z = button.position_m
            turned = poses.rotation_z(piece.yaw_rad) @ np.array([x, y, 0.0])
            found.append(np.array([*piece.position_m, z]) + turned)
    return found


@pytest.mark.parametrize(("robot", "scene"), [("talos", None), ("g1", "low_tabletop")])
def test_a_button_is_nearer_to_a_shoulder_than_a_hand_gets(robot, scene):
    model = RobotModel(load_description(robot))
    joints = [model.group(f"{hand}_arm")[0] for hand in ("left", "right")]
    links = [model.moved_links[model.joints[joint]] for joint in joints]
    shoulders = [model.frame_pose(model.q_home, link)[:3, 3] for link in links]

    for seed in SEEDS:
        for button in buttons_m(trial_of("press", seed, scene, robot)):
            assert min(math.dist(button, shoulder) for shoulder in shoulders) < model.description.reach_m


def test_one_of_two_buttons_is_asked_for():
    trial = trial_of("press", 7, "low_tabletop", "g1")

    assert len(buttons_m(trial)) == 2
    assert trial.aim in {f"{piece.name}/button" for piece in trial.scene.furniture if piece.controls}
