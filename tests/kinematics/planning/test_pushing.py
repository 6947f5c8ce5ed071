"""Where a hand pushes a door shut."""

import math
from dataclasses import replace

import numpy as np
import pytest

from kinematics.collision.validity import validity
from kinematics.geometry.shapes import Box
from kinematics.kernel.refusal import NotFree
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.planning.handle_planner import HandlePlanner
from kinematics.planning.pushing import assumed_bars, hand_points, outward_of, push_grasps, shut_at
from kinematics.requests.handle import HandlePlan, HandleRequest
from kinematics.requests.step import NoPlan
from kinematics.scene.opening_path import DoorArc
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.models.description import load_description

THICK_M, WIDE_M = 0.04, 0.60
HINGE = np.array([0.8, 0.75])


@pytest.fixture(scope="module")
def model():
    return RobotModel(load_description("talos"))


def request(model, side, opening):
    """A push at a door that hangs on one side, opened so far."""
    arc = DoorArc(HINGE * (1.0, side), 0.15 * side, side, 0.5 * WIDE_M, 0.0, 0.9)
    middle = arc.at(opening)
    pose = np.eye(4)
    yaw = arc.closed_yaw_rad - side * opening
    pose[:2, :2] = [[math.cos(yaw), -math.sin(yaw)], [math.sin(yaw), math.cos(yaw)]]
    pose[:3, 3] = middle.position_m
    panel = SceneObject("door", Box((THICK_M, WIDE_M, 1.6)), pose)
    return HandleRequest(
        q_start=model.q_home,
        stance=stance_at(model, model.q_home),
        scene=PlanningScene().with_object(panel),
        handle="door",
        parts=("door",),
        path=arc,
        s_from=opening,
        s_to=-0.1,
        hands=("left" if side > 0.0 else "right",),
        pushed="door",
    )


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("opening", [0.5, 1.1])
def test_the_hand_just_touches_the_front_from_outside(model, side, opening):
    asked = request(model, side, opening)
    panel_T_world = np.linalg.inv(asked.scene.objects["door"].world_T_object)
    outward = panel_T_world[:3, :3] @ outward_of(asked)

    grasps = list(push_grasps(model, asked))

    assert outward == pytest.approx([-1.0, 0.0, 0.0], abs=1e-9), "x of a front points inwards"
    assert grasps
    for grasp in grasps:
        hand = grasp.world_T_tcp
        points = hand_points(model, grasp.hand, model.q_home) @ hand[:3, :3].T + hand[:3, 3]
        local = points @ panel_T_world[:3, :3].T + panel_T_world[:3, 3]
        assert local[:, 0].max() == pytest.approx(-0.5 * THICK_M, abs=1e-9)
        assert abs(local[np.argmax(local[:, 0]), 1]) < 0.5 * WIDE_M, "it would push beside the door"


def test_a_place_that_was_tried_in_vain_is_left_out(model):
    asked = request(model, 1.0, 1.0)
    first = next(push_grasps(model, asked))
    again = next(push_grasps(model, replace(asked, excluded=frozenset({f"left {first.label}"}))))

    assert again.label != first.label


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("opening", [0.5, 1.1])
def test_a_bar_that_is_out_of_sight_is_taken_to_be_outside_near_the_free_edge(model, side, opening):
    asked = request(model, side, opening)
    panel_T_world = np.linalg.inv(asked.scene.objects["door"].world_T_object)
    hinge = panel_T_world @ np.array([*asked.path.hinge_m, 0.0, 1.0])

    bars = list(assumed_bars(asked))

    assert bars
    tops = []
    for bar in bars:
        middle = panel_T_world @ bar.world_T_object[:, 3]
        depth_m, wide_m, high_m = bar.shape.size_m
        assert middle[0] + 0.5 * depth_m == pytest.approx(-0.5 * THICK_M, abs=1e-6), "outside, on the front"
        assert abs(middle[1]) + 0.5 * wide_m < 0.5 * WIDE_M, "on the door"
        assert abs(middle[1] - hinge[1]) - 0.5 * wide_m > 0.75 * WIDE_M, "by the free edge"
        tops.append(bar.world_T_object[2, 3] + 0.5 * high_m)
    assert tops == sorted(tops, reverse=True)


def test_a_bar_that_was_seen_is_not_guessed(model):
    asked = request(model, 1.0, 1.1)
    assert not list(assumed_bars(replace(asked, handle="bar")))
    assert not list(assumed_bars(replace(asked, pushed="")))


def test_the_way_to_a_push_keeps_clear_of_where_the_bar_may_be(model):
    asked = request(model, -1.0, 1.1)
    bar = next(assumed_bars(asked))

    plan = HandlePlanner(model).plan(asked)

    assert isinstance(plan, HandlePlan)
    assert bar.name in plan.reach.scene.objects
    judge = validity(
        StandingRobot(model, asked.stance),
        PlanningScene().with_object(replace(bar, margin_m=0.0)),
        0.0,
        0.0,
    )
    assert all(judge.colliding_pair(q) is None for q in plan.reach.trajectory.q)


def test_a_push_that_leans_too_far_is_refused_for_that_and_not_for_a_collision(model, monkeypatch):
    asked = request(model, -1.0, 1.1)
    kernel = type(validity(StandingRobot(model, asked.stance), asked.scene))
    monkeypatch.setattr(kernel, "not_free", lambda _self, _x: NotFree("balance"))

    answer = HandlePlanner(model).plan(asked)

    assert isinstance(answer, NoPlan)
    assert "at the handle the robot would lean too far over its feet" in answer.reasons
    assert not any("collision" in reason for reason in answer.reasons)


def depth_m(asked, points, opening):
    """How deep points are beyond the outer face of a front that is so far open, m; of those before it."""
    arc = asked.path
    pose = arc.part_moved(asked.scene.objects["door"].world_T_object, asked.s_from, opening)
    local = (points - pose[:3, 3]) @ pose[:3, :3]
    before = np.abs(local[:, 1]) <= 0.5 * WIDE_M
    return float((local[before, 0] + 0.5 * THICK_M).max())


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_hand_that_keeps_its_heading_is_led_to_where_the_door_is_shut(side):
    g1 = RobotModel(load_description("g1"))
    asked = replace(request(g1, side, 1.0), s_to=-0.1)
    grasps = list(push_grasps(g1, asked))[:10]

    for grasp in grasps:
        lead_to = shut_at(g1, asked, grasp)
        tcp, way = grasp.world_T_tcp, asked.path.through(grasp.world_T_tcp[:3, 3], asked.s_from)
        hand = hand_points(g1, grasp.hand, g1.q_home) @ tcp[:3, :3].T
        there, sooner = (hand + way.at(s).position_m for s in (lead_to, lead_to + 0.03))
        assert depth_m(asked, there, asked.s_to) >= -1e-9
        assert depth_m(asked, sooner, asked.s_to) < 0.0


def test_a_hand_that_turns_as_it_likes_is_led_as_far_as_it_is_asked(model):
    asked = request(model, 1.0, 1.0)

    assert shut_at(model, asked, next(push_grasps(model, asked))) == asked.s_to
