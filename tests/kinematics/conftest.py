"""The robot that kinematics is tested on, built once."""

import pytest

from kinematics import poses
from kinematics.robot_model import RobotModel
from kinematics.scene import PlanningScene, SceneObject
from kinematics.shapes import Box, Cylinder
from kinematics.stance import stance_at
from robots.description import load_description


@pytest.fixture(scope="session")
def talos():
    return RobotModel(load_description("talos"))


@pytest.fixture(scope="session")
def stance(talos):
    return stance_at(talos, talos.q_home)


def table(top_m=0.85, edge_m=0.32, depth_m=0.6, width_m=1.4):
    return SceneObject(
        "table",
        Box((depth_m, width_m, 0.04)),
        poses.translation(edge_m + depth_m / 2, 0.0, top_m - 0.02),
        margin_m=0.015,
        movable=False,
    )


def cup(x=0.5, y=-0.2, top_m=0.85, radius_m=0.03, height_m=0.12, name="cup"):
    place = poses.translation(x, y, top_m + height_m / 2)
    return SceneObject(name, Cylinder(radius_m, height_m), place, margin_m=0.01)


@pytest.fixture
def tabletop():
    return PlanningScene().with_objects([table(), cup()])


@pytest.fixture(scope="session")
def make():
    class Make:
        cup = staticmethod(cup)
        table = staticmethod(table)

    return Make
