"""From a URDF to a checked reach by the guide's commands alone."""

import os
import subprocess
import sys
import tomllib
from pathlib import Path

import numpy as np
import pytest

from robots.models.description import load_description, load_robot
from tools.robot_data.drafting.draft import draft_of
from tools.robot_data.drafting.guesses import Guesses
from tools.robot_data.new import source_of
from tools.robot_data.reach import reach

ROOT = Path(__file__).resolve().parents[3]
ARM = "ur_description/urdf/ur5_robot.urdf"
TWO_ARMS = "tiago_description/robots/tiago_dual.urdf"
BIPED = "romeo_description/urdf/romeo.urdf"


def tool(*words, folder):
    return subprocess.run(
        [sys.executable, "-m", "tools.robot_data", *words],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        timeout=280,
    )


def drafted(urdf, base=None):
    source, guesses = source_of(urdf), Guesses()
    return draft_of(source.path, source.root, base, guesses), guesses


@pytest.fixture(scope="module")
def arm(tmp_path_factory):
    """What the command prints, and the folder that it makes."""
    folder = tmp_path_factory.mktemp("robots")
    return tool("new", ARM, "--folder", "ur5", "--samples", "500", folder=folder), folder


@pytest.mark.requirement("U4")
def test_an_arm_that_nobody_described_reaches_by_two_commands(arm):
    told, folder = arm
    assert told.returncode == 0, told.stderr

    reached = tool("reach", "./ur5", "--point", "0.5", "0.1", "0.9", folder=folder)

    assert reached.returncode == 0, reached.stdout + reached.stderr
    assert "done: arrival: the right hand is" in reached.stdout


def test_every_guess_is_printed_and_kept_beside_the_description(arm):
    told, folder = arm
    kept = (folder / "ur5" / "guesses.txt").read_text()

    assert kept in told.stdout
    for key in (
        "groups.right_arm",
        "body.base",
        "body.mount_xyz_m",
        "hand.tcp.right",
        "camera",
        "gains.arm_1",
        "home",
    ):
        assert f"\n{key} = " in f"\n{kept}"


def test_a_drafted_folder_is_a_robot_by_its_path(arm):
    _, folder = arm

    robot = load_robot(str(folder / "ur5"))

    assert robot.description.name == "ur5"
    assert robot.description.welded
    assert robot.description.hands == ("right",)


def test_a_point_that_no_hand_reaches_ends_at_inverse_kinematics(arm):
    _, folder = arm

    ended = reach(load_robot(str(folder / "ur5")), "right", np.array([3.0, 0.0, 1.0]), seed=0)

    assert (ended.done, ended.step) == (False, "inverse kinematics")


def test_two_arms_on_wheels_are_welded_with_lift_and_wheels_and_fingers_held():
    draft, guesses = drafted(TWO_ARMS)

    assert len(draft.limbs.groups["left_arm"]) == len(draft.limbs.groups["right_arm"]) == 7
    assert draft.held["torso_lift_joint"] == pytest.approx(0.175)
    assert {"wheel_left_joint", "hand_left_index_joint"} & set(draft.held)
    assert not draft.limbs.standing
    assert any(one.key == "held.torso_lift_joint" for one in guesses.all)


def test_legs_of_six_hinges_get_soles_below_their_ankles():
    draft, _ = drafted(BIPED)

    assert draft.limbs.standing
    for sole in draft.soles.values():
        assert sole.x_m[0] < 0.0 < sole.x_m[1]
        assert sole.y_m[0] < 0.0 < sole.y_m[1]


def test_what_could_stand_is_welded_when_that_is_asked_for():
    draft, _ = drafted(BIPED, "welded")

    assert not draft.soles
    assert "left_leg" not in draft.limbs.groups
    assert "LKneePitch" in draft.held


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["new", "nowhere.urdf"], "no URDF 'nowhere.urdf', neither here nor in example-robot-data"),
        (["new", "double_pendulum_description/urdf/double_pendulum_simple.urdf"], "no arm was found"),
        (["new", "ur_description/urdf/ur3.urdf"], "no link that all others hang on"),
        (["new", ARM, "--base", "floating"], "0 legs of six hinges were found; to stand takes two"),
        (["reach", "./nobody"], "no robot in './nobody': expected a folder with a description.toml"),
        (["reach", "panda", "--hand", "left"], "panda has no left hand; it has: right"),
    ],
)
def test_what_cannot_be_is_refused_with_the_part_by_name(tmp_path, words, says):
    told = tool(*words, folder=tmp_path)

    assert told.returncode == 2
    assert says in told.stderr


def test_what_is_written_can_be_read_by_a_person(arm):
    _, folder = arm
    data = tomllib.loads((folder / "ur5" / "description.toml").read_text())

    assert data["source"]["urdf"] == ARM
    assert data["body"]["base"] == "welded"
    assert load_description(str(folder / "ur5")).home.keys() >= set(data["home"])
