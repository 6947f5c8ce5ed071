"""An arm goes along with a trunk that bends: what its hand holds stays upright before the shoulder."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.ik.arm_frames import arm_kinematics
from kinematics.ik.body_gaze import with_joints
from kinematics.ik.gaze import in_picture
from kinematics.ik.held_upright import HeldInHand, arm_beside, arm_that_goes_along
from kinematics.model.robot_model import RobotModel
from robots.models.description import load_description

BEND, TURN = "waist_pitch_joint", "waist_yaw_joint"


@pytest.fixture(scope="module")
def model():
    return RobotModel(load_description("g1"))


def held_upright(model, q, hand):
    """Where a hand at a configuration has a thing that stands, shape (4, 4)."""
    world_T_tcp = model.frame_pose(q, model.description.tcp_frames[hand])
    return poses.transform(world_T_tcp[:3, :3].T, (0.02, 0.0, 0.03))


def tilt_rad(model, q, hand, tcp_T_object):
    at = arm_kinematics(model, hand).at(q)
    return float(np.arccos(np.clip(HeldInHand(tcp_T_object).upwards(at)[0, 2], -1.0, 1.0)))


@pytest.mark.parametrize("hand", ["left", "right"])
@pytest.mark.parametrize("seed", range(10))
def test_what_it_holds_stays_upright_and_near(model, hand, seed):
    rng = np.random.default_rng(seed)
    q = model.q_home
    tcp_T_object = held_upright(model, q, hand)
    trunk = {BEND: float(rng.uniform(-0.35, 0.45)), TURN: float(rng.uniform(-0.5, 0.5))}
    bent = with_joints(q, model, trunk)

    arm = arm_that_goes_along(model, q, trunk, hand, tcp_T_object)

    assert arm is not None
    along = with_joints(bent, model, arm)
    assert tilt_rad(model, along, hand, tcp_T_object) <= 0.05
    if abs(trunk[BEND]) > 0.1:
        assert tilt_rad(model, bent, hand, tcp_T_object) > 0.09
    before, after = arm_kinematics(model, hand).at(q), arm_kinematics(model, hand).at(along)
    thing = HeldInHand(tcp_T_object)
    far_m = [float(np.linalg.norm(thing.places_m(at)[0] - at.shoulder_m[0])) for at in (before, after)]
    assert far_m[1] == pytest.approx(far_m[0], abs=0.08)


def test_what_leaned_already_is_brought_upright(model):
    q = model.q_home
    leaning = held_upright(model, q, "left") @ poses.transform(poses.rotation_y(0.3), (0.0, 0.0, 0.0))

    arm = arm_that_goes_along(model, q, {BEND: -0.3}, "left", leaning)

    assert arm is not None
    along = with_joints(q, model, {BEND: -0.3, **arm})
    assert tilt_rad(model, along, "left", leaning) <= 0.05


def test_what_lies_in_the_hand_goes_on_lying(model):
    q = model.q_home
    lying = held_upright(model, q, "left") @ poses.transform(poses.rotation_x(0.5 * np.pi), (0.0, 0.0, 0.0))

    arm = arm_that_goes_along(model, q, {BEND: -0.3}, "left", lying)

    assert arm is not None
    along = with_joints(q, model, {BEND: -0.3, **arm})
    assert tilt_rad(model, along, "left", lying) == pytest.approx(0.5 * np.pi, abs=0.05)


def test_an_arm_that_cannot_says_so(model):
    q = model.q_home

    assert arm_that_goes_along(model, q, {BEND: 3.1}, "left", held_upright(model, q, "left")) is None


@pytest.mark.parametrize("holds", [False, True])
def test_beside_the_body_no_hand_is_in_the_picture(model, holds):
    q, camera = model.q_home, model.description.camera
    for hand in ("left", "right"):
        held = held_upright(model, model.q_home, hand) if holds else None
        arm = arm_beside(model, q, hand, held)
        assert arm is not None
        q = with_joints(q, model, arm)
        assert held is None or tilt_rad(model, q, hand, held) <= 0.05

    for posture, seen in ((model.q_home, True), (q, False)):
        world_T_camera = model.frame_pose(posture, camera.frame)
        hands = np.array(
            [
                model.frame_pose(posture, model.description.tcp_frames[hand])[:3, 3]
                for hand in ("left", "right")
            ]
        )
        shown = in_picture(hands, world_T_camera, camera.horizontal_fov_rad, camera.vertical_fov_rad)
        assert shown.any() == seen
