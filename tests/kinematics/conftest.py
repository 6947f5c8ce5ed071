"""The robot that kinematics is tested on, built once."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from kinematics.kernel.robot_arrays import humanoid_arrays
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.standing.free_coordinates import FreeCoordinates
from robots.models.description import load_description


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


@pytest.fixture(scope="session")
def arrays(talos):
    return humanoid_arrays(talos)


@pytest.fixture(scope="session")
def space(talos, stance):
    return FreeCoordinates(StandingRobot(talos, stance))


def turned_at(rng, position):
    turn = rng.normal(size=4)
    return poses.transform(poses.rotation_from_quaternion(turn / np.linalg.norm(turn)), np.asarray(position))


def clutter(rng, model, make, held=False):
    """A table, things in the air above it turned at random, and perhaps something in the right hand."""
    things = [make.table(top_m=rng.uniform(0.6, 0.9), edge_m=rng.uniform(0.25, 0.4))]
    for k in range(rng.integers(3, 10)):
        shape = [
            Box(tuple(rng.uniform(0.03, 0.2, 3))),
            Cylinder(rng.uniform(0.02, 0.06), rng.uniform(0.05, 0.3)),
            Ball(rng.uniform(0.02, 0.08)),
        ][k % 3]
        place = turned_at(rng, rng.uniform([0.3, -0.7, 0.7], [0.8, 0.7, 1.4]))
        things.append(SceneObject(f"thing_{k}", shape, place, margin_m=rng.uniform(0.0, 0.02)))
    scene = PlanningScene().with_objects(things)
    if not held:
        return scene
    gripper = model.description.grippers["right"]
    scene = scene.with_object(SceneObject("held", Cylinder(0.03, 0.15), np.eye(4), margin_m=0.01))
    return scene.with_attached("held", gripper.tcp_frame, np.eye(4), gripper.touch_links)


def random_point(rng, model, space):
    """Free coordinates around home: now near it, now anywhere within the limits."""
    columns = model.indices(space.joints)
    lower, upper = model.lower_rad[columns] + 0.01, model.upper_rad[columns] - 0.01
    x = space.from_q(model.q_home)
    x[:6] += (
        rng.uniform([-0.08, -0.08, -0.15, -0.2, -0.2, -0.3], [0.1, 0.08, 0.05, 0.2, 0.4, 0.3]) * rng.uniform()
    )
    x[6:] += (rng.uniform(lower, upper) - x[6:]) * rng.uniform(0.0, 0.8)
    x[6:] = np.clip(x[6:], lower, upper)
    return x


@pytest.fixture(scope="session")
def at_random():
    class AtRandom:
        scene = staticmethod(clutter)
        point = staticmethod(random_point)

    return AtRandom
