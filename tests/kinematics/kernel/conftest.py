"""Scenes and configurations at random, seeded."""

import numpy as np
import pytest

from kinematics import poses
from kinematics.free_coordinates import FreeCoordinates
from kinematics.kernel.robot_arrays import humanoid_arrays
from kinematics.scene import PlanningScene, SceneObject
from kinematics.shapes import Ball, Box, Cylinder


@pytest.fixture(scope="session")
def arrays(talos):
    return humanoid_arrays(talos)


@pytest.fixture(scope="session")
def space(talos, stance):
    return FreeCoordinates(talos, stance)


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
