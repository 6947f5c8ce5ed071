"""A person's hand comes around the robot's arm, and what its fingers hold stays where it is between them."""

import math
from itertools import pairwise

import numpy as np
import pytest

from executive.session.assembly import assemble
from robots.scenes.scene_description import Person, SceneDescription
from robots.simulated.body.person_model import hand_joint
from robots.simulated.people.person_hand import PINCH_N, PersonHand
from robots.simulated.people.person_pinch import SPARE_M, Pinch
from robots.simulated.people.person_way import choose_way

AHEAD = np.array([1.0, 0.0, 0.0])
PINCH = Pinch(np.zeros(3), 0.0, 0.05)


@pytest.fixture(scope="module")
def world():
    scene = SceneDescription("empty", people=(Person("Ana", (1.6, 0.0), math.pi),))
    return assemble("talos", scene, 0).world


@pytest.fixture
def hand(world):
    return PersonHand(world.physics, "Ana")


def least_room_m(hand, way):
    """Of the robot to the hand's pads, all along a way."""
    points = [
        start + share * (end - start)
        for start, end in pairwise((hand.place(), *way))
        for share in np.linspace(0.1, 1.0, 30)
    ]
    return min(hand.room_m(point, 0.0, PINCH.half_m + SPARE_M) for point in points)


def test_with_nothing_between_the_hand_goes_straight(hand):
    (only,) = choose_way(hand, np.array([1.1, 0.0, 1.2]), PINCH, AHEAD)

    np.testing.assert_array_equal(only, [1.1, 0.0, 1.2])


def test_a_robots_hand_on_the_straight_way_is_gone_around(hand, world):
    finger = world.truth.world_T_link("gripper_right_fingertip_1_link")[:3, 3]
    rest = hand.place()
    before = rest + 1.25 * (finger - rest)
    assert least_room_m(hand, (before,)) < 0.01

    way = choose_way(hand, before, PINCH, AHEAD)

    assert len(way) > 1
    np.testing.assert_array_equal(way[-1], before)
    assert least_room_m(hand, way) > 0.02


def off_centre_after(world, hand, force_n, seconds):
    """How far the middle between the pads has gone when one finger is pressed on like by a weight, m."""
    physics = world.physics
    upper, lower = (physics.model.joint(hand_joint("Ana", side)) for side in ("upper", "lower"))

    def middle_m():
        data = physics.data
        return 0.5 * float(data.qpos[upper.qposadr[0]] - data.qpos[lower.qposadr[0]])

    began_m = middle_m()
    for _ in range(int(seconds / 0.002)):
        hand.tick(0.002)
        # what is pinched keeps the pads apart and hangs on both of them
        physics.data.qfrc_applied[upper.dofadr[0]] += PINCH_N - 0.5 * force_n
        physics.data.qfrc_applied[lower.dofadr[0]] += PINCH_N + 0.5 * force_n
        world.robot.advance(0.002)
    return middle_m() - began_m


def test_what_fingers_hold_does_not_sink_with_both_of_them(world, hand):
    for _ in range(150):
        hand.tick(0.002)
        world.robot.advance(0.002)
    hand.pinching = True
    hand.hold_fast()

    assert abs(off_centre_after(world, hand, 5.0, 0.6)) < 0.004


def test_fingers_that_hold_nothing_fast_yield(world, hand):
    for _ in range(150):
        hand.tick(0.002)
        world.robot.advance(0.002)
    hand.pinching = True

    assert off_centre_after(world, hand, 5.0, 0.6) < -0.006
