from dataclasses import replace

import pytest

from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.collision.collision_world import CollisionWorld
from kinematics.collision.relaxed_start import relaxed_at
from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box
from kinematics.motion.verdict import CheckedTrajectory
from kinematics.motion_planner import MotionPlanner
from kinematics.requests.move import MovePlan, MoveRequest
from kinematics.requests.step import NoPlan
from kinematics.scene.planning_scene import PlanningScene, SceneObject


def judged(model, step):
    return TrajectoryChecker(model).check(step.trajectory, step.scene, step.concessions)


def ball_at_the_hand(talos, gap_m, movable=True):
    ahead = poses.translation(0.022 + 0.05 + gap_m, -0.058, 0.0)
    place = talos.frame_pose(talos.q_home, "tcp_right") @ ahead
    return SceneObject("ball", Ball(0.05), place, margin_m=0.03, movable=movable)


def test_a_start_that_is_far_enough_changes_nothing(talos):
    scene = PlanningScene().with_object(ball_at_the_hand(talos, 0.1))

    assert relaxed_at(talos, scene, talos.q_home) is scene


@pytest.mark.parametrize("gap_m", [0.015, -0.01], ids=["inside the margin", "believed to touch"])
def test_the_way_out_of_a_margin_is_planned_and_safe(talos, stance, gap_m):
    scene = PlanningScene().with_object(ball_at_the_hand(talos, gap_m))
    planner = MotionPlanner(talos)
    request = MoveRequest(
        talos.q_home, stance, scene, {"arm_right_4_joint": -2.0, "arm_right_1_joint": 0.0}, keep_others=True
    )

    assert CollisionWorld(talos, scene).collides(talos.q_home)
    answer = planner.answer(request)

    assert isinstance(answer, MovePlan)
    checked = judged(talos, answer.step)
    assert isinstance(checked, CheckedTrajectory)


def test_what_the_hand_does_not_touch_keeps_its_margin(talos):
    other = SceneObject("wall", Box((0.1, 1.0, 1.0)), poses.translation(0.9, 0.0, 1.0), margin_m=0.02)
    scene = PlanningScene().with_objects([ball_at_the_hand(talos, 0.015), other])

    relaxed = relaxed_at(talos, scene, talos.q_home)

    assert relaxed.objects["wall"].margin_m == 0.02
    assert 0.0 < relaxed.objects["ball"].margin_m < 0.03
    assert not relaxed.allowed


def test_contact_with_furniture_is_never_allowed(talos):
    scene = PlanningScene().with_object(ball_at_the_hand(talos, -0.01, movable=False))

    assert not relaxed_at(talos, scene, talos.q_home).allowed


@pytest.mark.requirement("M4")
@pytest.mark.parametrize("gap_m", [-0.02, 0.004], ids=["in the same place", "inside the margin"])
def test_what_is_held_and_seen_a_second_time_does_not_keep_the_hand_where_it_is(talos, stance, gap_m):
    ball = replace(ball_at_the_hand(talos, -0.02), margin_m=0.01)
    twin = SceneObject(
        "ball 2", ball.shape, ball.world_T_object @ poses.translation(0.1 + gap_m, 0.0, 0.0), margin_m=0.01
    )
    tcp_T_ball = poses.inverse(talos.frame_pose(talos.q_home, "tcp_right")) @ ball.world_T_object
    hand = talos.description.grippers["right"].touch_links
    scene = PlanningScene().with_objects([ball, twin]).with_attached("ball", "tcp_right", tcp_T_ball, hand)
    planner = MotionPlanner(talos)

    answer = planner.answer(
        MoveRequest(
            talos.q_home,
            stance,
            scene,
            {"arm_right_4_joint": -2.0, "arm_right_1_joint": 0.0},
            keep_others=True,
        )
    )

    assert isinstance(answer, MovePlan)
    checked = judged(talos, answer.step)
    assert isinstance(checked, CheckedTrajectory)


def distance_of_home_m(talos, item):
    """How near the robot is to something at home, by halving margins."""
    near_m, apart_m = 0.0, 0.05
    while apart_m - near_m > 1e-5:
        margin_m = 0.5 * (near_m + apart_m)
        too_near = CollisionWorld(
            talos, PlanningScene().with_object(replace(item, margin_m=margin_m))
        ).collides(talos.q_home)
        near_m, apart_m = (near_m, margin_m) if too_near else (margin_m, apart_m)
    return near_m


@pytest.mark.parametrize("spare_m", [-0.004, 0.0005, 0.0015, 0.0025, 0.004])
def test_a_reserve_gives_away_nothing_of_what_is_kept_without_it(talos, spare_m):
    # A way that is planned with a reserve is judged without it.
    ball = ball_at_the_hand(talos, 0.015)
    margin_m = distance_of_home_m(talos, ball) - spare_m
    scene = PlanningScene().with_object(replace(ball, margin_m=margin_m))

    planned_m = relaxed_at(talos, scene, talos.q_home, 0.003).objects["ball"].margin_m + 0.003

    assert planned_m >= relaxed_at(talos, scene, talos.q_home).objects["ball"].margin_m - 1e-9


@pytest.mark.parametrize(("spare_m", "given_m"), [(0.0005, 0.0015), (0.0025, 0.0)])
def test_a_start_that_just_keeps_its_margin_gets_two_millimetres_of_room(talos, spare_m, given_m):
    ball = ball_at_the_hand(talos, 0.015)
    margin_m = distance_of_home_m(talos, ball) - spare_m
    scene = PlanningScene().with_object(replace(ball, margin_m=margin_m))

    relaxed = relaxed_at(talos, scene, talos.q_home)

    assert relaxed.objects["ball"].margin_m == pytest.approx(margin_m - given_m, abs=1e-4)


def test_a_head_may_turn_while_a_hand_is_believed_to_be_in_furniture(talos, stance):
    scene = PlanningScene().with_object(ball_at_the_hand(talos, -0.01, movable=False))
    planner = MotionPlanner(talos)

    looking = planner.answer(
        MoveRequest(talos.q_home, stance, scene, {"head_2_joint": -0.1}, keep_others=True)
    )
    waving = planner.answer(
        MoveRequest(talos.q_home, stance, scene, {"arm_right_4_joint": -1.0}, keep_others=True)
    )

    assert isinstance(looking, MovePlan)
    checked = judged(talos, looking.step)
    assert isinstance(checked, CheckedTrajectory)
    assert isinstance(waving, NoPlan)
