"""What a skill needs of a robot stands in its record."""

from dataclasses import replace

import pytest

from robots.models.description import load_description
from trees.needs import lacks
from trees.readiness import lacking
from trees.registry import skill_called
from trees.skill import Need

NO_BARS = "its fingers do not get behind a bar"
RUBBER = "its hands are of rubber, in one piece: they reach and press, and cannot grasp"


def test_a_robot_without_grippers_lacks_a_hand(stage):
    toolbox = replace(stage.toolbox, grippers={})

    assert lacking(skill_called("pick"), toolbox).need is Need.HAND


def test_a_robot_that_does_not_walk_here_lacks_legs(stage):
    assert lacking(skill_called("walk_to"), replace(stage.toolbox, walking=None)).need is Need.LEGS


@pytest.mark.parametrize("action", ["pick", "wave", "say"])
def test_a_robot_that_has_everything_lacks_nothing(stage, action):
    assert lacking(skill_called(action), stage.toolbox) is None


@pytest.mark.parametrize(
    ("robot", "action", "lacking_parts"),
    [
        (
            "panda",
            "walk_to",
            ["feet; panda stands on a welded base", "eyes that aim; the camera of panda stays as it is"],
        ),
        ("panda", "look_at", ["eyes that aim; the camera of panda stays as it is"]),
        ("panda", "pick", []),
        ("panda", "say", []),
        ("talos", "walk_to", []),
        ("talos", "look_at", []),
        ("g1", "move", []),
        ("g1", "look_at", []),
        ("g1", "press", []),
        ("talos", "press", []),
        ("g1", "follow", []),
        ("g1", "guide", []),
        ("g1", "pick", []),
        ("g1", "open", []),
        ("g1", "close", []),
        ("g1", "turn_knob", ["a hand whose fingertips meet; the fingers of g1 close on a palm"]),
        ("g1", "place", []),
        ("g1", "put_in", []),
        ("g1", "walk_to", []),
        ("panda", "open", []),
        ("panda", "place", []),
    ],
)
def test_what_a_robot_lacks_is_told_from_its_data_with_the_reason(robot, action, lacking_parts):
    assert list(lacks(skill_called(action), load_description(robot))) == lacking_parts


def test_a_hand_that_cannot_grasp_says_why():
    robot = replace(load_description("g1"), grippers={}, cannot_grasp=RUBBER)

    assert list(lacks(skill_called("pick"), robot)) == [f"a hand that grips; {RUBBER}"]
    assert list(lacks(skill_called("open"), robot)) == [f"a hand that grips; {RUBBER}"]


def test_hands_that_grip_no_bar_say_why():
    robot = load_description("g1")
    hands = {name: replace(hand, cannot_grip_bars=NO_BARS) for name, hand in robot.grippers.items()}

    assert list(lacks(skill_called("open"), replace(robot, grippers=hands))) == [
        f"a hand that grips handles; {NO_BARS}"
    ]


def test_who_only_speaks_needs_nothing(stage):
    assert lacking(skill_called("say"), replace(stage.toolbox, grippers={}, walking=None)) is None
