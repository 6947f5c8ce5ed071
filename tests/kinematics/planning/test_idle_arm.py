"""The arm that takes hold of nothing helps to balance, unless that brings its hand to the body."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.planning.grasps import ABOVE_MIDDLE
from kinematics.planning.pick_task import PickTask
from kinematics.requests.pick import PickRequest
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.standing.reserves import LEAST_RESERVE_M
from robots.models.description import load_description

OTHER = {"left": "right", "right": "left"}


def task_at(model, x_m, y_m, top_m):
    """A pick of a carton on a low table."""
    table = SceneObject("table", Box((0.45, 1.1, 0.04)), poses.translation(0.5, 0.0, top_m - 0.02), 0.015)
    carton = SceneObject("carton", Box((0.053, 0.053, 0.131)), poses.translation(x_m, y_m, top_m + 0.066))
    scene = PlanningScene().with_objects([table, carton])
    request = PickRequest(model.q_home, stance_at(model, model.q_home), scene, "carton", ("left", "right"))
    return PickTask(model, request, (ABOVE_MIDDLE,), LEAST_RESERVE_M, upright=False, level=True)


def ways_of(task):
    return [way for candidate in task.candidates() if (way := task.solve(candidate)) is not None]


@pytest.fixture(scope="module")
def g1():
    return RobotModel(load_description("g1"))


@pytest.mark.parametrize(("x_m", "y_m", "top_m"), [(0.40, 0.0, 0.72), (0.36, -0.1, 0.68), (0.40, 0.1, 0.76)])
def test_an_arm_whose_hand_would_come_to_the_chest_stays_as_it_is(g1, x_m, y_m, top_m):
    task = task_at(g1, x_m, y_m, top_m)

    still = [way for way in ways_of(task) if way.still]

    assert still
    for way in still:
        goal, hand = task.completed(way), way.candidate.grasp.hand
        assert goal is not None
        columns = [task.space.index(joint) for joint in g1.description.groups[f"{OTHER[hand]}_arm"]]
        for curve in (way.approach, goal.lift):
            x = curve(np.linspace(0.0, 1.0, 9))
            np.testing.assert_allclose(x[:, columns], np.tile(task.x_start[columns], (9, 1)), atol=1e-9)
        q = task.planner.judge.configuration(way.x_pregrasp)
        tcp = g1.frame_pose(q, g1.description.grippers[hand].tcp_frame)
        away = np.linalg.norm(tcp[:3, 3] - way.candidate.grasp.world_T_tcp[:3, 3])
        np.testing.assert_allclose(away, way.candidate.grasp.approach_m, atol=0.005)


def test_hands_without_a_palm_help_to_balance_as_ever(talos, monkeypatch):
    def never(_self, _q, _hand):
        raise AssertionError("the other arm was held still")

    monkeypatch.setattr(PickTask, "_still", never)
    task = task_at(talos, 0.55, 0.0, 0.72)

    ways_of(task)

    assert any("colli" in reason and not reason.startswith("hand") for reason in task.reasons)
