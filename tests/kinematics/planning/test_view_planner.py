"""The eyes go to where more is seen: past what hides it, and no farther than the robot stands safely."""

import tracemalloc

import numpy as np
import pytest

from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.motion.verdict import CheckedTrajectory
from kinematics.planning.view_planner import ViewPlanner
from kinematics.requests.move import MovePlan
from kinematics.requests.step import NoPlan
from kinematics.requests.view import ViewRequest
from kinematics.scene.line_of_sight import hidden
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.models.description import load_description

TABLE = SceneObject("table", Box((0.6, 1.2, 0.04)), poses.translation(0.65, 0.0, 0.88), movable=False)


@pytest.fixture(scope="module")
def model():
    return RobotModel(load_description("talos"))


@pytest.fixture(scope="module")
def planner(model):
    return ViewPlanner(model)


def request(model, *items, points):
    stance = stance_at(model, model.q_home)
    scene = PlanningScene().with_objects([TABLE, *items])
    return ViewRequest(model.q_home, stance, scene, np.array(points), np.ones(len(points)), 0.1)


def seen_at_the_end(model, asked, answer):
    eye = model.frame_pose(answer.step.trajectory.q[-1], model.description.camera.frame)[:3, 3]
    return ~hidden(eye, asked.points_m, asked.scene.objects.values())


@pytest.mark.parametrize("side", [-0.15, 0.1])
def test_what_stands_behind_a_box_is_seen_from_beside_it(model, planner, side):
    box = SceneObject("brown box", Box((0.06, 0.16, 0.26)), poses.translation(0.45, side, 1.03))
    asked = request(model, box, points=[(0.53, side, 0.98), (0.53, side, 0.95)])

    answer = planner.plan(asked)

    assert isinstance(answer, MovePlan)
    assert seen_at_the_end(model, asked, answer).any()
    checked = TrajectoryChecker(model).check(answer.step.trajectory, answer.step.scene)
    assert isinstance(checked, CheckedTrajectory)


def test_what_is_walled_in_is_seen_from_nowhere(model, planner):
    walls = [
        SceneObject(f"wall {k}", Box(size), poses.translation(*place))
        for k, (size, place) in enumerate(
            [
                ((0.02, 0.30, 0.3), (0.45, 0.0, 1.05)),
                ((0.02, 0.30, 0.3), (0.75, 0.0, 1.05)),
                ((0.30, 0.02, 0.3), (0.60, 0.15, 1.05)),
                ((0.30, 0.02, 0.3), (0.60, -0.15, 1.05)),
                ((0.32, 0.32, 0.02), (0.60, 0.0, 1.21)),
            ]
        )
    ]

    answer = planner.plan(request(model, *walls, points=[(0.6, 0.0, 0.95)]))

    assert isinstance(answer, NoPlan)
    assert "hidden from everywhere" in answer.reasons


def test_thousands_of_places_that_were_not_seen_take_little_memory(model, planner):
    points = np.random.default_rng(3).uniform((1.5, -2.0, 0.0), (3.5, 2.0, 1.5), (2500, 3))
    asked = request(model, points=points)
    planner.plan(request(model, points=points[:5]))  # what is loaded once

    tracemalloc.start()
    try:
        planner.plan(asked)
        _, most = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()

    assert most < 20e6
