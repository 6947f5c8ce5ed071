"""How a palm comes to a bar, and how far a small robot leans and rises for a pull at it."""

import math

import numpy as np
import pytest

from kinematics.following.opening_motion import BREAK_FREE_N, com_shift_m, most_pull_n, turn_along
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.model.palm_grip import way_to_bar
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.planning.handle_planner import HandlePlanner
from kinematics.planning.pushing import hand_points
from kinematics.requests.handle import HandlePlan, HandleRequest
from kinematics.scene.opening_path import DoorArc, DrawerLine
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.standing.reserves import COM_RESERVE_M
from robots.models.description import load_description

RADIUS_M, STANDOFF_M = 0.012, 0.05
BAR_M = np.array([0.42, 0.22, 0.76])


@pytest.fixture(scope="module")
def g1():
    return RobotModel(load_description("g1"))


def drawer(model, hand):
    """A drawer's bar before one shoulder, its front behind it."""
    bar = BAR_M * (1.0, 1.0 if hand == "left" else -1.0, 1.0)
    lying = poses.transform(poses.rotation_x(0.5 * math.pi), bar)
    front = poses.translation(bar[0] + STANDOFF_M + 0.01, bar[1], bar[2])
    scene = PlanningScene().with_objects(
        [
            SceneObject("bar", Cylinder(RADIUS_M, 0.16), lying, 0.005, movable=False),
            SceneObject("front", Box((0.02, 0.45, 0.18)), front, 0.015, movable=False),
        ]
    )
    return HandleRequest(
        q_start=model.q_home,
        stance=stance_at(model, model.q_home),
        scene=scene,
        handle="bar",
        parts=("front", "bar"),
        path=DrawerLine(bar, 0.0),
        s_from=0.0,
        s_to=0.30,
        hands=(hand,),
    )


@pytest.mark.parametrize("hand", ["left", "right"])
def test_a_palm_is_laid_on_the_bar_of_a_drawer_that_it_can_draw_out(g1, hand):
    request = drawer(g1, hand)

    plan = HandlePlanner(g1).plan(request)

    assert isinstance(plan, HandlePlan)
    gripper, tcp = g1.description.grippers[hand], plan.grasp.world_T_tcp
    bar_m = tcp[:3, :3].T @ (request.path.closed_m - tcp[:3, 3])
    np.testing.assert_allclose(
        bar_m, [gripper.bar.along_m, gripper.grasped_at_m(2.0 * RADIUS_M), 0.0], atol=1e-9
    )
    # it comes within a quarter of a turn of squarely, and its fingers lie across the bar
    assert (tcp[:3, :3] @ way_to_bar(gripper))[0] > math.cos(0.5)
    assert abs(tcp[:3, 2] @ request.path.bar_axis) > 0.999


@pytest.mark.parametrize("hand", ["left", "right"])
def test_an_open_drawer_is_pushed_shut_beside_its_bar(g1, hand):
    open_m, before_m = 0.25, g1.description.pushing.before_m
    closed = np.array([before_m + open_m, 0.0, 0.78])
    bar, front = closed - (open_m + STANDOFF_M, 0.0, 0.0), closed - (open_m, 0.0, 0.0)
    lying = poses.transform(poses.rotation_x(0.5 * math.pi), bar)
    scene = PlanningScene().with_objects(
        [
            SceneObject("bar", Cylinder(RADIUS_M, 0.16), lying, 0.005, movable=False),
            SceneObject("front", Box((0.02, 0.45, 0.18)), poses.translation(*front), 0.015, movable=False),
        ]
    )
    request = HandleRequest(
        q_start=g1.q_home,
        stance=stance_at(g1, g1.q_home),
        scene=scene,
        handle="bar",
        parts=("front", "bar"),
        path=DrawerLine(closed, 0.0),
        s_from=open_m,
        s_to=-0.03,
        hands=(hand,),
        pushed="front",
    )

    plan = HandlePlanner(g1).plan(request)

    assert isinstance(plan, HandlePlan)
    tcp = plan.grasp.world_T_tcp
    points = hand_points(g1, hand, g1.q_home) @ tcp[:3, :3].T + tcp[:3, 3]
    assert points[:, 0].max() == pytest.approx(front[0] - 0.01, abs=1e-9), "it just touches the front"
    first = points[np.argmax(points[:, 0])]
    assert 0.08 < abs(first[1]) < 0.225, "beside the bar, and not beside the front"


def test_both_hands_come_to_a_bar_as_each_others_mirror_image(g1):
    left, right = (way_to_bar(g1.description.grippers[hand]) for hand in ("left", "right"))

    np.testing.assert_allclose(left * (1.0, -1.0, 1.0), right, atol=1e-12)
    assert left[1] < 0.0  # the left palm looks to the right


def test_pads_come_to_a_bar_along_themselves(talos):
    np.testing.assert_array_equal(way_to_bar(talos.description.grippers["left"]), [1.0, 0.0, 0.0])


def test_fingers_around_a_bar_turn_with_a_door_and_pads_hardly_do(g1, talos):
    arc = DoorArc(np.zeros(2), 0.0, 1.0, 0.4, 0.05, 0.9)

    palm, pads = (turn_along(arc, robot.description, "left", holding=True) for robot in (g1, talos))

    assert palm.weight > pads.weight


def test_a_palm_that_pushes_keeps_its_heading_and_one_that_holds_a_bar_turns_with_the_door(g1):
    arc, start = DoorArc(np.zeros(2), 0.0, 1.0, 0.4, 0.05, 0.9), poses.rotation_z(0.3)

    pushes, holds = (turn_along(arc, g1.description, "left", holding) for holding in (False, True))

    np.testing.assert_array_equal(pushes.rotation(arc, start, 1.0, 0.0), start)
    np.testing.assert_allclose(holds.rotation(arc, start, 1.0, 0.0), poses.rotation_z(1.3), atol=1e-12)


def test_a_light_robot_goes_back_for_a_pull_no_farther_than_the_checker_lets_it(g1):
    robot = StandingRobot.of(g1, stance_at(g1, g1.q_home))
    corners = robot.polygon.vertices_m
    middle = 0.5 * (corners.max(axis=0) + corners.min(axis=0))

    shift = com_shift_m(robot, np.array([-1.0, 0.0, 0.0]), 0.9, BREAK_FREE_N)

    assert robot.polygon.com_margin_m(middle + shift) > g1.description.com_margin_m + COM_RESERVE_M
    assert shift[0] < -0.02


@pytest.mark.parametrize(("robot", "least_n", "most_n"), [("talos", 58.0, 120.0), ("g1", 20.0, 45.0)])
def test_a_robot_pulls_at_what_is_locked_no_harder_than_it_bears(robot, least_n, most_n):
    model = RobotModel(load_description(robot))
    standing = StandingRobot(model, stance_at(model, model.q_home))

    pull_n = most_pull_n(standing, np.array([-1.0, 0.0, 0.0]), 0.9)

    assert least_n < pull_n < most_n


def test_a_welded_robot_pulls_as_hard_as_it_likes():
    model = RobotModel(load_description("panda"))

    assert (
        most_pull_n(StandingRobot(model, stance_at(model, model.q_home)), np.array([-1.0, 0.0, 0.0]), 1.0)
        == np.inf
    )
