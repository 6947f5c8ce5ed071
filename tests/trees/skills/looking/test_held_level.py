"""A trunk that aims tilts what a hand holds: the arm goes along, or the trunk hardly bends."""

from types import SimpleNamespace

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Cylinder
from kinematics.ik.body_gaze import with_joints
from kinematics.model.robot_model import RobotModel
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.models.description import load_description
from trees.policy import TreePolicy
from trees.skills.looking import aiming_leaf
from trees.skills.looking.aiming_leaf import level_enough
from trees.skills.looking.look_at import joints_of


def with_in_hand(robot, *, holding):
    """What may be called: a robot at home, with a cup that stands in its left hand or empty ones."""
    model = RobotModel(load_description(robot))
    frame = model.description.tcp_frames["left"]
    scene = PlanningScene()
    if holding:
        upright = poses.transform(model.frame_pose(model.q_home, frame)[:3, :3].T, (0.0, 0.0, 0.0))
        links = model.description.grippers["left"].touch_links
        cup = SceneObject("cup", Cylinder(0.03, 0.1), upright)
        scene = scene.with_objects([cup]).with_attached("cup", frame, upright, links)
    motion = SimpleNamespace(reference=lambda: model.q_home)
    return SimpleNamespace(model=model, world=SimpleNamespace(scene=scene), motion=motion)


def tilt_rad(toolbox, joints):
    body, model = toolbox.world.scene.attached["cup"], toolbox.model
    q = with_joints(model.q_home, model, joints)
    return float(np.arccos(min(1.0, (model.frame_pose(q, body.frame) @ body.frame_T_object)[2, 2])))


@pytest.mark.parametrize("gaze", TreePolicy().level_gazes)
def test_with_something_in_hand_a_trunk_bends_as_far_and_the_arm_goes_along(gaze):
    joints = joints_of(gaze, load_description("g1"))
    toolbox = with_in_hand("g1", holding=True)

    empty, holding = level_enough(with_in_hand("g1", holding=False), joints), level_enough(toolbox, joints)

    assert empty == joints
    assert joints["waist_pitch_joint"] < -0.3
    assert {name: holding[name] for name in joints} == joints
    assert tilt_rad(toolbox, joints) > 0.25
    assert tilt_rad(toolbox, holding) <= 0.05


def test_where_the_arm_cannot_the_trunk_hardly_bends(monkeypatch):
    monkeypatch.setattr(aiming_leaf, "arm_that_goes_along", lambda *_: None)
    joints = joints_of(TreePolicy().level_gazes[1], load_description("g1"))

    holding = level_enough(with_in_hand("g1", holding=True), joints)

    assert abs(holding["waist_pitch_joint"]) <= 0.12
    assert holding["waist_yaw_joint"] == joints["waist_yaw_joint"]


def test_a_neck_moves_nothing_that_is_held():
    joints = joints_of(TreePolicy().level_gazes[0], load_description("talos"))

    assert level_enough(with_in_hand("talos", holding=True), joints) == joints
