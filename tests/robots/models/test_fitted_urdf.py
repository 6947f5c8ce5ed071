"""A URDF made fit by a robot's data: what is held, what gets limits, what is left out."""

import xml.etree.ElementTree as ElementTree

import pytest

from robots.errors import DescriptionError
from robots.models.fitted_urdf import bound_joints, with_joints_held, without_world
from robots.models.urdf import add_collision_box, moving_joints, read_urdf

ROBOT = """
<robot name="cart">
  <link name="world"/>
  <link name="base"><collision><geometry><sphere radius="0.1"/></geometry></collision></link>
  <link name="lift"/><link name="finger"/><link name="thumb"/><link name="arm"/>
  <joint name="to_world" type="fixed"><parent link="world"/><child link="base"/></joint>
  <joint name="lift" type="prismatic"><parent link="base"/><child link="lift"/><axis xyz="0 0 1"/>
    <limit lower="0" upper="0.4" velocity="1" effort="1"/></joint>
  <joint name="arm" type="continuous"><parent link="lift"/><child link="arm"/><axis xyz="0 0 1"/></joint>
  <joint name="finger" type="revolute"><parent link="arm"/><child link="finger"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" velocity="1" effort="1"/></joint>
  <joint name="thumb" type="revolute"><parent link="arm"/><child link="thumb"/><axis xyz="0 0 1"/>
    <mimic joint="finger" multiplier="-1"/><limit lower="-1" upper="1" velocity="1" effort="1"/></joint>
</robot>"""


def robot():
    return ElementTree.fromstring(ROBOT)


def joint(urdf, name):
    return next(item for item in urdf.findall("joint") if item.get("name") == name)


def test_held_joints_stand_where_they_are_told_and_what_mimics_them_is_held_too():
    held = with_joints_held(robot(), {"lift": 0.2, "finger": 0.0})

    assert moving_joints(held) == ("arm",)
    assert joint(held, "lift").find("origin").get("xyz") == "0.0 0.0 0.2"
    assert joint(held, "thumb").get("type") == "fixed"


def test_a_joint_that_is_to_be_held_and_is_not_there_is_named():
    with pytest.raises(DescriptionError, match=r"\[held\].*'lifft'"):
        with_joints_held(robot(), {"lifft": 0.2})


def test_a_joint_without_end_becomes_a_hinge_with_the_limits_of_the_data():
    urdf = robot()

    bound_joints(urdf, {"arm": (-3.0, 3.0), "finger": (-0.5, 0.5)})

    assert joint(urdf, "arm").get("type") == "revolute"
    assert joint(urdf, "arm").find("limit").get("upper") == "3.0"
    assert joint(urdf, "finger").find("limit").get("upper") == "1"


def test_an_empty_world_is_no_link_of_the_robot():
    urdf = robot()

    without_world(urdf)

    assert urdf.find("link").get("name") == "base"
    assert "to_world" not in [item.get("name") for item in urdf.findall("joint")]


def test_a_box_instead_takes_the_place_of_the_links_own_shapes():
    urdf = robot()

    add_collision_box(urdf, "base", {"size_m": (0.1, 0.1, 0.1), "instead": True})

    assert [shape[1][0].tag for shape in urdf.findall("link[@name='base']/collision")] == ["box"]


def test_mesh_paths_of_a_users_own_packages_begin_at_the_root(tmp_path):
    file = tmp_path / "my_robot" / "robot.urdf"
    file.parent.mkdir()
    meshes = ["package://my_robot/hand.stl", "arm.stl", "file:///there/leg.stl"]
    file.write_text("<robot>" + "".join(f'<mesh filename="{mesh}"/>' for mesh in meshes) + "</robot>")

    found = [mesh.get("filename") for mesh in read_urdf(file, tmp_path).iter("mesh")]

    assert found == [f"{tmp_path}/my_robot/hand.stl", f"{tmp_path}/my_robot/arm.stl", "/there/leg.stl"]


@pytest.mark.parametrize(("text", "says"), [(None, "there is no"), ("<robot", "is no URDF")])
def test_a_urdf_that_is_not_there_or_none_is_named(tmp_path, text, says):
    file = tmp_path / "robot.urdf"
    if text is not None:
        file.write_text(text)

    with pytest.raises(DescriptionError, match=f"urdf: .*{says}"):
        read_urdf(file, tmp_path)
