"""The robot's body in the simulator: what touches what, and with which limits."""

import dataclasses

import numpy as np
import pytest

from kinematics.errors import MissingPartError
from kinematics.geometry import poses
from kinematics.model.robot_description import HANDS
from robots.interface.hardware import RobotData
from robots.models.description import load_robot
from robots.scenes.scene_description import SceneDescription
from robots.scenes.scene_file import load_scene
from robots.simulated.body.body_model import sole_name
from robots.simulated.body.geom_roles import Role
from robots.simulated.body.physics import Physics
from robots.simulated.world import build_world

HARDWARE = load_robot("talos").hardware


@pytest.fixture(scope="module")
def physics(description):
    return Physics(RobotData(description, HARDWARE), load_scene("tabletop"))


def labels(physics, role):
    return [physics.geom_label[i] for i in np.flatnonzero(physics.geom_role == role)]


def may_touch(physics, first, second):
    model = physics.model
    return bool(
        (model.geom_contype[first] & model.geom_conaffinity[second])
        | (model.geom_contype[second] & model.geom_conaffinity[first])
    )


def test_each_hand_has_three_pads_and_they_are_boxes_of_the_described_size(physics, description):
    pads = np.flatnonzero(physics.geom_role == Role.PAD)
    expected = [link for hand in HANDS for link in description.grippers[hand].pad_links]

    assert sorted(labels(physics, Role.PAD)) == sorted(expected)
    sizes = dict(zip(expected, 2 * description.grippers["left"].pad_half_size_m, strict=True))
    for pad in pads:
        assert physics.model.geom_size[pad] == pytest.approx(sizes[physics.geom_label[pad]])


def test_finger_hulls_never_touch_objects_but_do_touch_furniture(physics):
    cup, table = physics.scene_geom_id("red cup"), physics.scene_geom_id("table/top")
    fingers = np.flatnonzero(physics.geom_role == Role.FINGER)

    assert len(fingers) == 14
    assert not any(may_touch(physics, finger, cup) for finger in fingers)
    assert all(may_touch(physics, finger, table) for finger in fingers)


def test_pads_which_fill_the_gap_between_two_fingers_never_touch_the_robot_itself(physics):
    pads = np.flatnonzero(physics.geom_role == Role.PAD)
    own = np.flatnonzero(np.isin(physics.geom_role, (Role.BODY, Role.FINGER)))

    assert not any(may_touch(physics, pad, part) for pad in pads for part in own)
    for role in (Role.FLOOR, Role.FURNITURE, Role.OBJECT):
        for thing in np.flatnonzero(physics.geom_role == role):
            assert all(may_touch(physics, pad, thing) for pad in pads)


def test_every_other_link_with_a_shape_touches_objects_and_furniture(physics):
    cup, table = physics.scene_geom_id("red cup"), physics.scene_geom_id("table/top")
    body = np.flatnonzero(physics.geom_role == Role.BODY)

    assert {
        "torso_2_link",
        "leg_left_4_link",
        "arm_right_7_link",
        "gripper_left_base_link",
        "head_2_link",
    } <= set(labels(physics, Role.BODY))
    assert all(may_touch(physics, geom, cup) and may_touch(physics, geom, table) for geom in body)


def test_drawn_meshes_touch_nothing(physics):
    drawn = np.flatnonzero(physics.geom_role == Role.NONE)

    assert not physics.model.geom_contype[drawn].any()
    assert not physics.model.geom_conaffinity[drawn].any()


def test_the_soles_are_the_described_rectangles_with_their_bottom_on_the_sole_plane(physics, description):
    for sole in description.soles:
        geom = physics.geom_id(sole_name(sole))
        position, size = physics.model.geom_pos[geom], physics.model.geom_size[geom]
        assert (position[0] - size[0], position[0] + size[0]) == pytest.approx(sole.x_m)
        assert (position[1] - size[1], position[1] + size[1]) == pytest.approx(sole.y_m)
        assert position[2] - size[2] == pytest.approx(0.0, abs=1e-12)


def test_actuators_have_the_described_gains_and_limits_in_the_order_of_setpoints(physics, description):
    model = physics.model
    assert [model.actuator(i).name for i in range(model.nu)] == list(description.actuated)
    for i, name in enumerate(description.actuated):
        gains, effort = HARDWARE.gains[name], description.limits[name].effort
        assert model.actuator_gainprm[i, 0] == gains.stiffness
        assert model.actuator_biasprm[i, 1:3] == pytest.approx((-gains.stiffness, -gains.damping))
        assert tuple(model.actuator_forcerange[i]) == (-effort, effort)


def test_the_simulated_body_weighs_what_the_planning_model_weighs(physics, robot_model):
    own = physics.model.body_subtreemass[physics.base_body]

    assert own == pytest.approx(robot_model.mass_kg, rel=1e-6)


def test_the_simulated_frames_are_where_the_planning_model_has_them(physics, robot_model, description):
    physics.refresh_after_change()
    base_T_world = poses.inverse(physics.body_pose(physics.base_body))
    model_T_world = poses.inverse(robot_model.frame_pose(robot_model.q_home, description.base_link))
    names = [description.camera.frame, description.imu_link, "tcp_left", "tcp_right", "arm_left_7_link"]
    names += [sole.frame for sole in description.soles]
    for name in names:
        simulated = base_T_world @ physics.body_pose(physics.body_id(name))
        planned = model_T_world @ robot_model.frame_pose(robot_model.q_home, name)
        assert simulated == pytest.approx(planned, abs=1e-9)


def test_the_home_posture_touches_nothing_but_the_floor(physics):
    assert {physics.geom_label[geom] for pair in physics.data.contact.geom for geom in pair} <= {
        "floor", "leg_left_6_link", "leg_right_6_link", "table/top", "red cup", "blue box",
    }  # fmt: skip


def test_a_robot_without_eyes_is_simulated_and_says_so_when_one_asks_for_its_camera():
    robot = load_robot("g1")
    blind = RobotData(dataclasses.replace(robot.description, head_camera=None), robot.hardware)

    world = build_world(blind, SceneDescription("empty"), np.random.default_rng(0), drawn=False)

    with pytest.raises(MissingPartError, match="g1 has no camera"):
        world.truth.world_T_camera()
