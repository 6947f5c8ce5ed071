"""A posture that cannot be taken is refused for its true cause, whoever judges it."""

import pytest

from kinematics.collision import validity
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion_planner import MotionPlanner
from kinematics.requests.move import MoveRequest
from kinematics.requests.step import NoPlan
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.standing.free_coordinates import free_coordinates

WALL = SceneObject("wall", Box((0.05, 2.0, 2.0)), poses.translation(0.15, 0.0, 1.0))
FORWARD_M = 0.11
"""So far ahead the pelvis is over the toes."""
CASES = [
    ("balance", FORWARD_M, {}, PlanningScene(), "the robot would lean too far over its feet"),
    ("limits", 0.0, {"head_1_joint": 0.78}, PlanningScene(), "a joint would come too near to its limit"),
    ("contact", 0.0, {}, PlanningScene().with_object(WALL), "collides with wall"),
    ("nothing", 0.0, {}, PlanningScene(), None),
]


@pytest.fixture(params=["kernel", "samples"])
def judge(request, talos, stance, monkeypatch):
    """The judge of a scene: compiled, or Coal point by point."""
    if request.param == "samples":
        monkeypatch.setattr(validity, "_kernel_is_there", lambda: False)
    return lambda scene: validity.validity(StandingRobot(talos, stance), scene)


@pytest.mark.requirement("F1")
@pytest.mark.parametrize(
    ("forward_m", "joints", "scene", "told"), [case[1:] for case in CASES], ids=[c[0] for c in CASES]
)
def test_the_cause_is_told(talos, stance, judge, forward_m, joints, scene, told):
    space = free_coordinates(StandingRobot(talos, stance))
    x = space.home.copy()
    x[0] += forward_m
    for joint, angle in joints.items():
        x[space.index(joint)] = angle

    said = judge(scene).why_not(x)

    assert said is None if told is None else told in said


def test_a_move_that_would_tip_the_robot_is_not_called_a_collision(talos, stance):
    plan = MotionPlanner(talos).answer(
        MoveRequest(talos.q_home, stance, PlanningScene(), pelvis_m=(FORWARD_M, 0.0, 0.0))
    )

    assert isinstance(plan, NoPlan)
    assert plan.message.endswith("the robot would lean too far over its feet")
