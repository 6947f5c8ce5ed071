"""Keys become words: what each means in each mode, and what a key held down says."""

import numpy as np
import pytest

from executive.manual.keys import COMMON, KEYS, JogKeys
from executive.manual.words import BaseJog, GripJog, JogFeed
from kinematics.following.jog_reference import HandJog, JointJog

ARMS = {
    "left": tuple(f"arm_left_{k}" for k in range(1, 8)),
    "right": tuple(f"arm_right_{k}" for k in range(1, 8)),
}


def keys():
    return JogKeys(ARMS, ("pan", "tilt"))


def word(jog, *pressed):
    """The word of the last of some keys, each a second after the one before."""
    return [jog.press(key, float(at)).word for at, key in enumerate(pressed)][-1]


@pytest.mark.parametrize(
    ("key", "way"),
    [
        ("up", (1, 0, 0)),
        ("down", (-1, 0, 0)),
        ("left", (0, 1, 0)),
        ("right", (0, -1, 0)),
        (";", (0, 0, 1)),
        (".", (0, 0, -1)),
    ],
)
def test_arrows_and_two_more_move_the_hand_along_the_axes(key, way):
    said = word(keys(), key)

    assert isinstance(said, HandJog)
    assert said.linear_m_s / np.linalg.norm(said.linear_m_s) == pytest.approx(way)
    assert not said.angular_rad_s.any()


@pytest.mark.parametrize(("key", "frame"), [("w", "world"), ("e", "tool"), ("q", "base")])
def test_a_key_chooses_the_frame(key, frame):
    assert word(keys(), key, "up").frame == frame


@pytest.mark.parametrize(("key", "hand"), [("x", "left"), ("h", "right")])
def test_a_key_chooses_the_other_hand(key, hand):
    assert word(keys(), key, "up").hand == hand


def test_digits_are_the_joints_of_the_arm_and_r_turns_them_round():
    jog = keys()

    forth, back = word(jog, "n", "3"), word(jog, "r", "3")

    assert isinstance(forth, JointJog)
    assert forth.joint == back.joint == "arm_right_3"
    assert forth.rate_rad_s == -back.rate_rad_s > 0.0


@pytest.mark.parametrize(
    ("key", "way"),
    [("i", (1, 0)), (",", (-1, 0)), ("j", (0, 1)), ("l", (0, -1)), ("u", (1, 1)), ("o", (1, -1))],
)
def test_the_base_goes_by_the_keys_of_every_teleoperation(key, way):
    said = word(keys(), "b", key)

    assert isinstance(said, BaseJog)
    assert (np.sign(said.linear_m_s), np.sign(said.angular_rad_s)) == way


def test_no_key_has_two_meanings_in_one_mode():
    for mode, own in KEYS.items():
        assert not own & set(COMMON), mode


def test_every_key_of_a_mode_means_something_there():
    jog = keys()
    for mode, choosing in (("hand", "h"), ("joints", "n"), ("base", "b")):
        jog.press(choosing, 0.0)
        for key in sorted(KEYS[mode]):
            assert jog.press(key, 1.0).known, (mode, key)


def test_an_unknown_key_says_nothing():
    pressed = keys().press("%", 0.0)

    assert pressed.word is None
    assert not pressed.known


def test_the_three_speeds_follow_one_another():
    jog, speeds = keys(), []
    for _ in range(4):
        speeds.append(np.linalg.norm(word(jog, "up").linear_m_s))
        jog.press("z", 0.0)

    assert speeds[0] == speeds[3]
    assert len({*speeds[:3]}) == 3


def test_held_down_a_key_goes_on_and_in_steps_it_does_not():
    jog = keys()
    held = [jog.press("up", 0.04 * k).word for k in range(3)]
    jog.press("s", 1.0)
    steps = [jog.press("up", 2.0 + 0.04 * k).word for k in range(3)]

    assert None not in held
    assert steps[0] is not None
    assert steps[1:] == [None, None]


@pytest.mark.parametrize(("key", "opens"), [("f", True), ("g", False)])
def test_fingers_open_and_close(key, opens):
    assert word(keys(), "x", key) == GripJog("left", opens)


def test_a_space_brakes_and_enter_gives_the_robot_back():
    jog = keys()

    assert jog.press(" ", 0.0).brakes
    assert jog.press("enter", 1.0).gives_back


def test_a_word_is_good_for_a_moment_and_then_silence():
    feed = JogFeed()

    feed.say(BaseJog(0.1, 0.0), 1.0)

    assert feed.fresh(1.14) is not None
    assert feed.fresh(1.16) is None
