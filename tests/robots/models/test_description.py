"""A robot is a folder of data: what is read, and what is refused."""

import dataclasses
import importlib.resources
import math
import re
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest

from kinematics.errors import MissingPartError
from kinematics.geometry import poses
from kinematics.model.robot_description import GROUPS
from kinematics.model.robot_model import RobotModel
from robots.errors import DescriptionError, UnknownRobotError
from robots.interface.gripper_reading import read_gripper
from robots.models import description as reader
from robots.models.description import load_description, load_robot, load_robot_for_tasks
from robots.models.urdf import add_collision_box, moving_joints, with_fixed_joints
from robots.outside import known_robots

ARM = """
<robot name="arm">
  <link name="base"/><link name="upper"/><link name="hand"/><link name="finger"/><link name="thumb"/>
  <joint name="b_turn" type="revolute"><parent link="base"/><child link="upper"/>
    <origin xyz="0.1 0 0.2" rpy="0.3 -0.2 0.5"/><axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" velocity="1" effort="1"/></joint>
  <joint name="a_fixed" type="fixed"><parent link="upper"/><child link="hand"/></joint>
  <joint name="finger" type="prismatic"><parent link="hand"/><child link="finger"/>
    <origin xyz="0 0 0.05" rpy="0 0 1.5707963267948966"/><axis xyz="0 1 0"/>
    <limit lower="0" upper="0.1" velocity="1" effort="1"/></joint>
  <joint name="thumb" type="prismatic"><parent link="hand"/><child link="thumb"/>
    <origin xyz="0 0 0.05"/><axis xyz="0 -1 0"/><mimic joint="finger" multiplier="0.5"/>
    <limit lower="0" upper="0.1" velocity="1" effort="1"/></joint>
</robot>"""


def joint(urdf, name):
    return next(item for item in urdf.findall("joint") if item.get("name") == name)


def numbers(element, key):
    return [float(item) for item in element.find("origin").attrib[key].split()]


@pytest.mark.requirement("U4")
@pytest.mark.parametrize("name", known_robots())
def test_every_known_robot_becomes_a_model(name):
    model = RobotModel(load_description(name))

    assert set(GROUPS) <= set(model.description.groups)
    assert np.all(model.lower_rad < model.upper_rad)
    assert np.all((model.acceleration > 0.0) & (model.jerk > 0.0) & (model.effort > 0.0))
    for hand in model.description.hands:
        assert model.frame_id(model.description.tcp_frames[hand])


def test_fingers_that_are_open_away_from_zero_are_open_in_the_planning_model():
    model = RobotModel(load_description("panda"))
    left, right, tcp = model.frame_poses(
        model.q_home, ["panda_leftfinger", "panda_rightfinger", model.description.tcp_frames["right"]]
    )

    opening = tcp[:3, 1]  # the TCP's y axis

    assert (left - right)[:3, 3] @ opening == pytest.approx(0.08, abs=1e-9)
    assert (left + right)[:3, 3] @ opening == pytest.approx(2 * tcp[:3, 3] @ opening, abs=1e-9)


def test_held_joints_stand_where_they_are_told_and_mimics_follow():
    held = with_fixed_joints(ElementTree.fromstring(ARM), "finger|thumb", {"finger": 0.04})

    assert moving_joints(held) == ("b_turn",)
    assert numbers(joint(held, "finger"), "xyz") == pytest.approx([-0.04, 0.0, 0.05], abs=1e-12)
    assert numbers(joint(held, "thumb"), "xyz") == pytest.approx([0.0, -0.02, 0.05], abs=1e-12)


@pytest.mark.parametrize("turn", [0.7, -2.0, math.pi / 2])
def test_a_held_hinge_is_turned_about_its_own_axis(turn):
    loose = ElementTree.fromstring(ARM)
    held = with_fixed_joints(loose, "b_turn", {"b_turn": turn})

    before, after = (
        poses.rotation_z(yaw) @ poses.rotation_y(pitch) @ poses.rotation_x(roll)
        for roll, pitch, yaw in (numbers(joint(urdf, "b_turn"), "rpy") for urdf in (loose, held))
    )

    assert after == pytest.approx(before @ poses.rotation_y(turn), abs=1e-12)
    assert numbers(joint(held, "b_turn"), "xyz") == pytest.approx([0.1, 0.0, 0.2])


def test_joints_are_ordered_depth_first_by_name():
    assert moving_joints(ElementTree.fromstring(ARM)) == ("b_turn", "finger", "thumb")


def test_a_collision_box_on_a_link_that_is_not_there_is_refused():
    with pytest.raises(DescriptionError, match="elbow"):
        add_collision_box(ElementTree.fromstring(ARM), "elbow", {"size_m": [1, 1, 1]})


def test_an_unknown_robot_is_refused_with_the_nearest_name():
    with pytest.raises(UnknownRobotError, match="panda"):
        load_description("pandas")


@pytest.fixture
def written(tmp_path, monkeypatch):
    """A robot "changed" whose data are G1's with a pattern of its file replaced."""

    def write(pattern, by=""):
        own = importlib.resources.files("robots.models") / "g1"
        for name in ("description.toml", "disabled_collisions.toml"):
            (tmp_path / name).write_text((own / name).read_text("utf-8"), "utf-8")
        file = tmp_path / "description.toml"
        text, count = re.subn(pattern, by, file.read_text("utf-8"), flags=re.DOTALL)
        assert count
        file.write_text(text, "utf-8")
        monkeypatch.setattr(reader, "robot_folder", lambda _name: tmp_path)
        return "changed"

    return write


CAMERA = r"\[camera\].*?(?=\n\[(?!camera))"


def test_a_robot_without_a_camera_says_so_when_one_asks_for_it(written):
    with pytest.raises(MissingPartError, match="changed has no camera"):
        _ = load_description(written(CAMERA)).camera


def test_a_robot_without_eyes_is_not_given_tasks(written):
    with pytest.raises(DescriptionError, match=r"changed.* no camera"):
        load_robot_for_tasks(written(CAMERA))


def test_the_motors_of_a_right_hand_turn_the_other_way_where_they_are_mirrored():
    left, right = (load_description("g1").grippers[hand] for hand in ("left", "right"))

    assert right.joints == tuple(name.replace("left", "right") for name in left.joints)
    for position in (0.0, 0.4, 1.0):
        assert right.joints_at(position) == pytest.approx([-at for at in left.joints_at(position)])
    for ours, theirs in zip(left.pad_position_m, right.pad_position_m, strict=True):
        assert theirs == pytest.approx((ours[0], -ours[1], ours[2]))


def test_motors_stay_within_the_joints_limits_all_along():
    description = load_description("g1")
    for gripper in description.grippers.values():
        for joint, *ends in zip(gripper.joints, gripper.joints_at(0.0), gripper.joints_at(1.0), strict=True):
            low, high = description.limits[joint].position
            assert low <= min(ends) <= max(ends) <= high, joint


def test_each_motor_of_a_hand_has_an_effort_of_its_own():
    limits = load_description("g1").limits

    assert limits["right_hand_index_0_joint"].effort > limits["right_hand_index_1_joint"].effort


@pytest.mark.parametrize(
    ("pattern", "by", "says"),
    [
        (r"\[gripper\]", '[gripper]\njoint = "left_hand_thumb_1_joint"', "either a joint or a table motor"),
        (r"open_rad = 1.0 ", "open_rad = 0.9 ", "from closed_rad = 0.0 to open_rad = 1.0"),
        (r"\[\[gripper.motor\]\].*?(?=\n\n\[\[frame)", "", "either a joint or a table motor"),
        (r"thumb_0_joint\"\nopen", 'thumb_9_joint"\nopen', "no joint 'left_hand_thumb_9_joint'"),
    ],
)
def test_a_hand_that_cannot_be_driven_is_refused(written, pattern, by, says):
    with pytest.raises(DescriptionError, match=says):
        load_robot(written(pattern, by))


@pytest.mark.parametrize("name", ["talos", "panda", "g1"])
def test_a_robot_with_eyes_is_given_tasks(name):
    assert load_robot_for_tasks(name).description.missing_for_tasks == ()


def test_a_gaze_names_the_joints_that_there_are():
    assert load_description("panda").camera.aimed(0.1, 0.2, 0.3) == {}
    assert load_description("talos").camera.aimed(0.1, 0.2) == {"head_1_joint": 0.2, "head_2_joint": 0.1}


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"base": "hanging"}, "floating or welded"),
        ({"base": "floating"}, "no sole to stand on"),
        ({"base_link": "panda_link"}, "panda_link"),
        ({"grippers": {}}, "cannot_grasp"),
        ({"home": {f"panda_joint{i}": 0.0 for i in range(1, 8)}}, "panda_joint4 at 0 is outside"),
    ],
)
def test_data_that_contradict_themselves_are_refused(changes, says):
    panda = load_description("panda")
    links = [link.attrib["name"] for link in ElementTree.fromstring(panda.urdf).findall("link")]

    with pytest.raises(DescriptionError, match=says):
        reader._require_consistent(dataclasses.replace(panda, **changes), links)


@pytest.fixture
def changed(tmp_path, monkeypatch):
    """Loads TALOS with one line of its description written otherwise."""
    text = (importlib.resources.files("robots.models") / "talos" / "description.toml").read_text("utf-8")
    monkeypatch.setattr(reader, "robot_folder", lambda _name: tmp_path)

    def load(line, instead):
        assert line in text
        (tmp_path / "description.toml").write_text(text.replace(line, instead, 1), "utf-8")
        return load_robot("mine")

    return load


@pytest.mark.parametrize(
    ("line", "instead", "says"),
    [
        ("lean_joint =", "leen_joint =", "camera.leen_joint: unknown key; the nearest is 'lean_joint'"),
        ("imu_link =", "imu_lnk =", "body.imu_lnk: unknown key; the nearest is 'imu_link'"),
        (
            "foot_torque_nm = 0.1",
            'foot_torque_nm = "low"',
            "noise.foot_torque_nm: must be a number, not 'low'",
        ),
        ("payload_kg = 6.0", "", "gripper.payload_kg: is missing"),
        ("battery_low = 0.15", "battery = 0.15", "health.battery: unknown key; the nearest is 'battery_low'"),
        ("dcm_gain = 2.0", "dcm_gain = nan", "walking.dcm_gain: must be finite, not nan"),
        ("stride_reach_m =", "stride_rech_m =", "the nearest is 'stride_reach_m'"),
        ("x_m = [-0.11, 0.10]", "x_m = [-0.11]", "sole[0].x_m: must be a list of 2 numbers, not [-0.11]"),
        ('side = "left"', 'side = "lefft"', "sole[0].side: unknown side 'lefft'; the nearest is 'left'"),
        ("stiffness = 5000.0", "stifness = 5000.0", "gains.leg.stifness: unknown key"),
        ('leg = "leg_.*"', 'leg = "leg_(.*"', "gains.members.leg: 'leg_(.*' is no regular expression"),
        ("com_margin_m = 0.02", "", "limits.com_margin_m: is missing, for a robot with soles"),
        ("leg = 120.0", "", "[limits.jerk] says nothing of the kind 'leg'"),
        ("[friction]", "[friction", "is no TOML"),
    ],
)
def test_a_description_that_cannot_be_read_is_refused_with_robot_file_key_and_reason(
    changed, line, instead, says
):
    with pytest.raises(DescriptionError) as refused:
        changed(line, instead)

    assert str(refused.value).startswith("robot 'mine': ")
    assert says in str(refused.value)
    assert "description.toml" in str(refused.value) or says.startswith("[")


@pytest.mark.parametrize(("name", "told"), [("talos", "50 mm, 4.2 Nm"), ("panda", "50 mm, 4.2 N")])
def test_what_a_gripper_feels_is_told_in_the_unit_of_its_joint(name, told):
    robot = load_robot(name)
    gripper, grip = robot.description.grippers["right"], robot.hardware.grips["right"]
    at = {"talos": -0.30, "panda": 0.025}[name]

    assert str(read_gripper(gripper, grip, at, -4.2)) == told


@pytest.mark.parametrize(
    ("name", "elbow", "contact_nm"), [("talos", "arm_left_4_joint", 10.0), ("g1", "left_elbow_joint", 5.0)]
)
def test_every_arm_with_a_hand_feels_contact_also_where_no_effort_is_named(name, elbow, contact_nm):
    robot = load_robot(name)

    felt = robot.hardware.contact_effort_nm

    arms = {joint for hand in ("left", "right") for joint in robot.description.groups[f"{hand}_arm"]}
    assert set(felt) == arms
    assert felt[elbow] == pytest.approx(contact_nm)
