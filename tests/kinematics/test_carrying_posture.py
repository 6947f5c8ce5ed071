"""What is carried is upright before the shoulder, higher where something stands beside it."""

import numpy as np
import pytest

from kinematics.collision.collision_world import CollisionWorld
from kinematics.geometry import poses
from kinematics.geometry.shapes import Cylinder
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.planning.gesture_planner import GesturePlanner
from kinematics.requests.gesture import CarryRequest
from kinematics.requests.move import MovePlan
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.models.description import load_description

SWAY_M = 0.05


@pytest.fixture(scope="module")
def model():
    return RobotModel(load_description("talos"))


def carried(model, *others):
    """The planner's answer, where the cup is at its end, and the scene."""
    frame = model.description.tcp_frames["left"]
    upright = poses.transform(poses.rotation_y(-0.5 * np.pi), (0.0, 0.0, 0.0))  # held from above
    cup = SceneObject("cup", Cylinder(0.03, 0.13), upright)
    links = model.description.grippers["left"].touch_links
    scene = PlanningScene().with_objects([cup, *others]).with_attached("cup", frame, upright, links)
    answer = GesturePlanner(model).plan(
        CarryRequest(model.q_home, stance_at(model, model.q_home), scene, "cup", 1)
    )
    assert isinstance(answer, MovePlan)
    q = answer.step.trajectory.q[-1]
    return q, model.frame_pose(q, frame) @ scene.attached["cup"].frame_T_object, scene


def test_it_is_upright_and_raised_no_more_than_it_needs(model):
    _, alone, _ = carried(model)
    place = alone[:3, 3]
    far = SceneObject(
        "can", Cylinder(0.03, 0.11), poses.translation(place[0] + 0.4, place[1], place[2]), movable=True
    )

    _, beside, _ = carried(model, far)

    assert alone[2, 2] >= np.cos(0.03)
    assert beside[2, 3] == pytest.approx(place[2], abs=0.01)


@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_the_sway_of_the_first_steps_reaches_nothing_that_stands_beside_it(model, side):
    _, alone, _ = carried(model)
    at = alone[:3, 3] + (0.0, side * 0.1, -0.07)
    can = SceneObject("can", Cylinder(0.03, 0.11), poses.translation(*at), movable=True)

    q, cup, scene = carried(model, can)

    assert cup[2, 2] >= np.cos(0.03)
    assert CollisionWorld(model, scene, SWAY_M).colliding_pair(q) is None
