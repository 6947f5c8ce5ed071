"""A hand that is deep in a box of furniture finds its way out."""

import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.ik.solver import inverse_kinematics
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion_planner import MotionPlanner
from kinematics.requests.move import MovePlan, MoveRequest
from kinematics.requests.step import NoPlan
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.models.description import load_description

HAND_M = (0.62, 0.22, 1.15)
HALF_M = 0.19
DEEP_M = 0.5


@pytest.fixture(scope="module")
def model():
    return RobotModel(load_description("talos"))


def walls(*, shut):
    """Around the hand, open towards the robot, or not even there."""
    x, y, z = HAND_M
    long, wide, thin = DEEP_M, 2.0 * HALF_M, 0.02
    sides = {
        "top": ((long, wide, thin), (x, y, z + HALF_M)),
        "bottom": ((long, wide, thin), (x, y, z - HALF_M)),
        "left": ((long, thin, wide), (x, y + HALF_M, z)),
        "right": ((long, thin, wide), (x, y - HALF_M, z)),
    }
    if shut:  # around the forearm
        sides["lid"] = ((0.05, wide, 0.08), (x - 0.25, y, z + 0.13))
        sides["sill"] = ((0.05, wide, 0.08), (x - 0.25, y, z - 0.13))
        sides["post"] = ((0.05, 0.08, wide), (x - 0.25, y - 0.13, z))
        sides["jamb"] = ((0.05, 0.08, wide), (x - 0.25, y + 0.13, z))
    scene = PlanningScene()
    for name, (size, middle) in sides.items():
        scene = scene.with_object(SceneObject(name, Box(size), poses.translation(*middle)))
    return scene


@pytest.fixture(scope="module")
def way_home(model):
    stance = stance_at(model, model.q_home, [sole.frame for sole in model.description.soles])
    hand = poses.translation(*HAND_M)
    q = inverse_kinematics(StandingRobot(model, stance), "left").solve(hand, model.q_home).q
    planner = MotionPlanner(model)
    return lambda seed, shut=False: planner.answer(MoveRequest(q, stance, walls(shut=shut), seed=seed))


@pytest.mark.requirement("M4")
def test_whatever_the_seed_a_way_home_is_found(way_home):
    assert all(isinstance(way_home(seed), MovePlan) for seed in range(8))


def test_an_arm_that_is_shut_in_is_told_of(way_home):
    assert isinstance(way_home(0, shut=True), NoPlan)
