"""What is offered is upright, within reach, and not behind a finger for who pulls."""

from dataclasses import replace
from typing import ClassVar

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Cylinder
from kinematics.ik.arm_frames import arm_kinematics
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.planning.gesture_planner import BESIDE_FINGERS, GesturePlanner
from kinematics.planning.gesture_task import GestureTask, Wish
from kinematics.requests.gesture import OfferRequest
from kinematics.requests.move import MovePlan
from kinematics.requests.step import NoPlan
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.models.description import load_description


@pytest.fixture(scope="module")
def model():
    return RobotModel(load_description("talos"))


@pytest.mark.parametrize("hand", ["left", "right"])
@pytest.mark.parametrize("person", [(1.4, -0.5, 0.9), (1.4, 0.5, 0.9)])
def test_what_hangs_from_a_hand_can_be_pulled_out_between_the_fingers(model, hand, person):
    frame = model.description.tcp_frames[hand]
    hanging = poses.transform(poses.rotation_y(-0.5 * np.pi), (0.0, 0.0, 0.0))  # the hand points down at it
    cup = SceneObject("cup", Cylinder(0.03, 0.1), hanging)
    links = model.description.grippers[hand].touch_links
    scene = PlanningScene().with_objects([cup]).with_attached("cup", frame, hanging, links)
    stance = stance_at(model, model.q_home)

    answer = GesturePlanner(model).plan(OfferRequest(model.q_home, stance, scene, "cup", person, 1))

    assert isinstance(answer, MovePlan)
    tcp = model.frame_pose(answer.step.trajectory.q[-1], frame)
    upright = (tcp @ scene.attached["cup"].frame_T_object)[:3, 2]
    towards = np.array(person[:2]) - tcp[:2, 3]
    assert upright[2] >= np.cos(0.06)
    assert abs(tcp[:2, 1] @ towards) / np.linalg.norm(towards) <= BESIDE_FINGERS + 0.01


class _NoWay(GestureTask):
    """Finds no way to any posture, and keeps what was wished for."""

    wishes: ClassVar[list[Wish]] = []

    def reach(self, name, wish):
        self.wishes.append(wish)
        return NoPlan("no way", {})

    def swing(self, _postures):
        raise NotImplementedError

    def room_for(self, _sway_m):
        raise NotImplementedError


@pytest.mark.parametrize("hand", ["left", "right"])
def test_a_palm_between_object_and_person_is_the_last_resort(model, hand):
    frame = model.description.tcp_frames[hand]
    held = poses.transform(np.eye(3), (0.0, 0.0, 0.0))  # grasped from the side, it stands
    cup = SceneObject("cup", Cylinder(0.03, 0.1), held)
    links = model.description.grippers[hand].touch_links
    scene = PlanningScene().with_objects([cup]).with_attached("cup", frame, held, links)
    person = (1.4, 0.0, 0.9)
    _NoWay.wishes.clear()

    request = OfferRequest(model.q_home, stance_at(model, model.q_home), scene, "cup", person, 1)
    GesturePlanner(model, _NoWay).plan(request)

    here = arm_kinematics(model, hand).at(model.q_home)
    before, behind = (
        replace(here, tcp_m=np.array([[0.5, 0.0, 1.2]]), world_R_tcp=poses.rotation_z(turn)[None])
        for turn in (0.0, np.pi)
    )
    assert [wish.good(before) for wish in _NoWay.wishes] == [True, True, True, True]
    assert [wish.good(behind) for wish in _NoWay.wishes] == [False, False, False, True]
