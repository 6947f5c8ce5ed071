"""A person takes hold of an object where the robot's fingers are not."""

import math

import numpy as np
import pytest

from executive.session.assembly import assemble
from kinematics.geometry.shapes import Box, Cylinder
from robots.scenes.scene_description import Person, SceneDescription
from robots.simulated.body.person_model import hand_joint
from robots.simulated.people.person_hand import PersonHand
from robots.simulated.people.person_pinch import choose_pinch

AHEAD = np.array([1.0, 0.0, 0.0])


@pytest.fixture(scope="module")
def world():
    scene = SceneDescription("empty", people=(Person("Ana", (1.6, 0.0), math.pi),))
    return assemble("talos", scene, 0).world


@pytest.fixture
def hand(world):
    return PersonHand(world.physics, "Ana")


@pytest.fixture
def finger(world):
    return world.truth.world_T_link("gripper_right_fingertip_1_link")[:3, 3]


def test_far_from_the_robot_it_pinches_from_above_and_below(hand):
    pinch = choose_pinch(hand, np.array([0.9, 0.0, 1.2]), Cylinder(0.03, 0.12), AHEAD)

    assert pinch.roll_rad == 0.0
    assert pinch.half_m == pytest.approx(0.06)


def test_under_a_robots_finger_it_pinches_from_both_sides(hand, finger):
    below = finger - [0.0, 0.0, 0.06]

    pinch = choose_pinch(hand, below, Box((0.05, 0.05, 0.12)), AHEAD)

    assert pinch.roll_rad == pytest.approx(0.5 * math.pi)
    assert hand.room_m(below + pinch.offset_m, pinch.roll_rad, pinch.half_m) >= 0.008


def test_there_is_no_room_where_a_robots_finger_is(hand, finger):
    assert hand.room_m(finger, 0.0, 0.0) < 0.0
    assert hand.room_m(finger + np.array([0.6, 0.0, 0.0]), 0.0, 0.05) == pytest.approx(0.05)


def test_fingers_close_at_a_hands_pace(hand, world):
    physics = world.physics
    index = physics.model.joint(hand_joint("Ana", "upper"))
    hand.pinching = False
    for _ in range(400):
        hand.tick(0.002)
        world.robot.advance(0.002)
    opened = float(physics.data.qpos[index.qposadr[0]])
    hand.pinching = True
    fastest = 0.0
    for _ in range(100):
        hand.tick(0.002)
        world.robot.advance(0.002)
        fastest = max(fastest, abs(float(physics.data.qvel[index.dofadr[0]])))

    assert opened > 0.10
    assert 0.05 < fastest < 0.25
