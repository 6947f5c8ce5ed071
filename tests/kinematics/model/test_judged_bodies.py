"""A robot that the checker could not judge is refused when it is loaded, with the reason."""

import dataclasses
import re

import coal
import pinocchio as pin
import pytest

from kinematics.errors import ModelError
from kinematics.model.judged_bodies import require_judged_solids
from kinematics.model.robot_model import RobotModel
from robots.models.description import load_description


@pytest.fixture(scope="module")
def panda():
    return load_description("panda")


def with_joint(description, name, kind):
    urdf, count = re.subn(rf'(<joint name="{name}" type=")\w+', rf"\1{kind}", description.planning_urdf)
    assert count == 1
    return dataclasses.replace(description, planning_urdf=urdf)


def with_capsule(description, link):
    """The link's mesh as a cylinder that Pinocchio is told to round off."""
    (old,) = re.findall(rf'<link name="{link}".*?</link>', description.planning_urdf, re.DOTALL)
    cylinder = '<geometry><cylinder radius="0.05" length="0.2"/></geometry>'
    new = re.sub("<geometry>.*?</geometry>", cylinder, old, flags=re.DOTALL)
    new = new.replace("<collision>", '<collision name="rounded">')
    new = new.replace("</link>", '<collision_checking><capsule name="rounded"/></collision_checking></link>')
    return dataclasses.replace(description, planning_urdf=description.planning_urdf.replace(old, new))


@pytest.mark.parametrize(
    ("kind", "says"),
    [
        ("prismatic", "'panda_joint3' slides"),
        ("continuous", "'panda_joint3' turns without end"),
        ("planar", "'panda_joint3' is no hinge"),
    ],
)
def test_a_robot_with_a_body_joint_that_is_no_bounded_hinge_is_refused(panda, kind, says):
    with pytest.raises(ModelError, match=f"panda: joint {says}"):
        RobotModel(with_joint(panda, "panda_joint3", kind))


def test_a_robot_with_a_capsule_is_refused(panda):
    with pytest.raises(ModelError, match="panda: link 'panda_link4' has a capsule"):
        RobotModel(with_capsule(panda, "panda_link4"))


@pytest.mark.parametrize(
    "shape", [coal.Capsule(0.1, 0.2), coal.Cone(0.1, 0.2), coal.Ellipsoid(0.1, 0.2, 0.3)]
)
def test_no_solid_of_another_kind_comes_to_planner_or_checker(shape):
    geometry = pin.GeometryModel()
    geometry.addGeometryObject(pin.GeometryObject("part", 0, pin.SE3.Identity(), shape))

    with pytest.raises(ModelError, match=f"a robot: 'part' is a {type(shape).__name__}"):
        require_judged_solids("a robot", geometry)


@pytest.mark.parametrize("name", ["talos", "g1", "panda"])
def test_the_robots_that_are_there_are_taken(name):
    assert RobotModel(load_description(name)).geometry().ngeoms > 0
