"""Fingers on a palm come in level wherever they can, and the pelvis leans no more than it may."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.planning.pick_planner import PickPlanner
from kinematics.requests.pick import PickPlan, PickRequest
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.models.description import load_description

# Where one that is 20 degrees steep costs less than a level one (x, y of the cup, height of the table).
STEEP_IS_CHEAPER = [(0.36, 0.22, 0.68), (0.39, 0.21, 0.69), (0.36, -0.26, 0.71)]


@pytest.fixture(scope="module")
def model():
    return RobotModel(load_description("g1"))


@pytest.mark.parametrize(("x_m", "y_m", "top_m"), STEEP_IS_CHEAPER)
def test_a_level_grasp_goes_before_a_cheaper_steep_one(model, x_m, y_m, top_m):
    table = SceneObject("table", Box((0.5, 1.1, 0.04)), poses.translation(0.53, 0.0, top_m - 0.02), 0.01)
    cup = SceneObject("cup", Cylinder(0.03, 0.14), poses.translation(x_m, y_m, top_m + 0.07), 0.005)
    scene = PlanningScene().with_objects([table, cup])
    stance = stance_at(model, model.q_home)

    plan = PickPlanner(model).plan(PickRequest(model.q_home, stance, scene, "cup", ("left", "right")))

    assert isinstance(plan, PickPlan)
    assert abs(plan.grasp.world_T_tcp[2, 0]) < np.sin(np.radians(5.0))
    for step in (plan.reach, plan.approach, plan.lift):
        turned = [poses.rotation_from_quaternion(q[3:7]) for q in step.trajectory.q]
        assert max(float(np.arccos(one[2, 2])) for one in turned) < 0.7
