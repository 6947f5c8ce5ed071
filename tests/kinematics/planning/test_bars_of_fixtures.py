"""A hand takes a bar that has others beside it with its fingers no wider apart than fits."""

from dataclasses import replace

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.planning.finger_room import BESIDE_M, thick_m
from kinematics.planning.handle_planner import HandlePlanner
from kinematics.requests.handle import HandlePlan, HandleRequest
from kinematics.requests.step import NoPlan
from kinematics.scene.planning_scene import SceneObject
from robots.models.description import load_description
from tests.trees.cabinet_seen import CABINET, believed, seen
from trees.beliefs.openings.handles import beside_bar, handles_in


@pytest.fixture(scope="module")
def model():
    return RobotModel(load_description("talos"))


def request(model, scene, target, s_from=0.0):
    return HandleRequest(
        q_start=model.q_home,
        stance=stance_at(model, model.q_home),
        scene=scene,
        handle=target.handle,
        parts=(target.part, target.handle),
        path=target.path,
        s_from=s_from,
        s_to=target.open_to,
        beside=beside_bar(target, scene),
        seed=3,
    )


def look_at(part):
    look = seen(CABINET)
    return believed(look), next(one for one in handles_in(look) if one.moves.part == part)


def test_fingers_open_between_the_handles_above_and_below(model):
    scene, target = look_at("middle drawer")

    plan = HandlePlanner(model).plan(request(model, scene, target))

    assert isinstance(plan, HandlePlan)
    gripper = model.description.grippers[plan.grasp.hand]
    assert plan.grasp.opening_m < gripper.max_opening_m
    up = abs(plan.grasp.world_T_tcp[2, 1])
    away_m = 0.112 - 0.007  # to the next bar's near side
    assert (0.5 * plan.grasp.opening_m + thick_m(gripper)) * up < away_m - 0.5 * BESIDE_M


def test_only_fingers_may_come_near_what_is_beside_a_bar(model):
    scene, target = look_at("middle drawer")
    asked = request(model, scene, target)

    plan = HandlePlanner(model).plan(asked)

    gripper = model.description.grippers[plan.grasp.hand]
    near = {
        next(iter(one.pair - set(asked.beside)))
        for one in plan.approach.concessions
        if one.pair & set(asked.beside)
    }
    assert near == set(gripper.finger_links)
    assert gripper.base_link not in near


def test_what_leaves_no_room_beside_a_bar_is_said(model):
    scene, target = look_at("middle drawer")
    bar = scene.objects[target.handle].world_T_object
    for number, up_m in enumerate((0.035, -0.035)):
        rail = Box((0.06, 0.4, 0.01))
        pose = poses.translation(0.0, 0.0, up_m) @ np.block([[np.eye(3), bar[:3, 3:]], [np.eye(4)[3:]]])
        scene = scene.with_object(SceneObject(f"rail {number}", rail, pose, 0.01, movable=False))

    answer = HandlePlanner(model).plan(request(model, scene, target))

    assert isinstance(answer, NoPlan)
    assert "no room for fingers beside the handle" in answer.reasons


def test_long_pads_stop_before_the_front_behind_a_bar(model):
    scene, target = look_at("top drawer")
    bar, nearer = scene.objects[target.handle], poses.translation(*(0.018 * -target.path.at(0.0).outward))
    scene = scene.with_object(replace(bar, world_T_object=nearer @ bar.world_T_object))
    path = target.path.through((nearer @ bar.world_T_object)[:3, 3], 0.0)
    target = replace(target, path=path)

    plan = HandlePlanner(model).plan(request(model, scene, target))

    assert isinstance(plan, HandlePlan)
    gripper = model.description.grippers[plan.grasp.hand]
    front, outward = scene.objects[target.part], target.path.at(0.0).outward
    face = front.world_T_object[:3, 3] @ outward + 0.5 * front.shape.size_m[0]
    tip = plan.grasp.world_T_tcp @ [gripper.pad_half_size_m[0][2] + gripper.closing_advance_m, 0.0, 0.0, 1.0]
    assert tip[:3] @ outward > face
