"""Legs without a closed form: postures are judged by the kernel as by Coal."""

import numpy as np
import pytest

from kinematics.collision.collision_world import CollisionWorld
from kinematics.collision.validity import SampledValidity, validity
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.kernel.collision_kernel import CollisionKernel
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.standing.free_coordinates import free_coordinates
from robots.models.description import load_description

EXTRA_M, OWN_M = 0.004, 0.005


@pytest.fixture(scope="module")
def standing():
    g1 = RobotModel(load_description("g1"))
    return StandingRobot(g1, stance_at(g1, g1.q_home))


@pytest.mark.parametrize("seed", range(3))
def test_the_kernel_and_coal_judge_a_small_humanoid_alike(standing, seed):
    rng = np.random.default_rng(seed)
    top = SceneObject("top", Box((0.5, 0.8, 0.03)), poses.translation(0.5, 0.0, 0.72), 0.01, movable=False)
    things = [
        SceneObject(
            f"can {k}", Cylinder(0.035, 0.12), poses.translation(*rng.uniform((0.3, -0.3), (0.6, 0.3)), 0.8)
        )
        for k in range(6)
    ]
    scene = PlanningScene().with_objects([top, *things])
    judge = validity(standing, scene, EXTRA_M, OWN_M)
    coal = SampledValidity(standing, CollisionWorld(standing.model, scene, EXTRA_M, OWN_M))
    space = free_coordinates(standing)
    home = space.from_q(standing.model.q_home)
    x = home + rng.normal(size=(120, space.size)) * np.where(np.arange(space.size) < 6, 0.02, 0.35)

    ours, theirs = ([one.points_are_free(point[None]) for point in x] for one in (judge, coal))

    assert isinstance(judge, SampledValidity)
    assert isinstance(judge._world, CollisionKernel)
    assert ours == theirs
    assert 5 < sum(ours) < 115
    pairs = [(judge.colliding_pair(q), coal.colliding_pair(q)) for q in space.to_q(x)[0]]
    assert [one is None for one, _ in pairs] == [other is None for _, other in pairs]
