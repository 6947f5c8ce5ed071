from dataclasses import replace

import numpy as np
import pytest

from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.collision.collision_world import CollisionWorld
from kinematics.collision.wide_berth import BERTH_M, wide_berth
from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box
from kinematics.motion.verdict import CheckedTrajectory
from kinematics.motion_planner import MotionPlanner
from kinematics.requests.move import MovePlan, MoveRequest
from kinematics.scene.planning_scene import PlanningScene, SceneObject

GOAL = {"arm_right_4_joint": -1.2, "arm_right_1_joint": 0.4}
MARGIN_M = 0.01


def straight(talos):
    """Configurations on the straight line from home to the goal."""
    goal = talos.q_home.copy()
    for joint, angle in GOAL.items():
        goal[7 + talos.joint_index(joint)] = angle
    return talos.q_home + np.linspace(0.0, 1.0, 60)[:, None] * (goal - talos.q_home)


def is_near(talos, ball, rows, margin_m):
    world = CollisionWorld(talos, PlanningScene().with_object(replace(ball, margin_m=margin_m)))
    return any(world.collides(q) for q in rows)


@pytest.fixture(scope="module")
def ball(talos):
    """Just so far from the straight line that it is free."""
    rows = straight(talos)
    beside = talos.frame_pose(rows[len(rows) // 2], "tcp_right")[:3, 3]
    for away_m in np.arange(0.08, 0.4, 0.002):
        place = poses.translation(*(beside - np.array([0.0, away_m, 0.0])))
        found = SceneObject("ball", Ball(0.04), place, margin_m=MARGIN_M)
        if not is_near(talos, found, rows, MARGIN_M + 0.002):
            return found
    raise AssertionError("the ball is never beside the line")


@pytest.mark.requirement("S6")
def test_a_move_keeps_twice_the_margin_from_a_thing_where_there_is_room(talos, stance, ball):
    scene = PlanningScene().with_object(ball)
    assert is_near(talos, ball, straight(talos), 2.0 * MARGIN_M - 0.003)
    planner = MotionPlanner(talos)

    plan = planner.answer(MoveRequest(talos.q_home, stance, scene, GOAL, keep_others=True))

    assert isinstance(plan, MovePlan)
    assert not is_near(talos, ball, plan.step.trajectory.q[::10], 2.0 * MARGIN_M - 0.001)
    assert plan.step.scene.objects["ball"].margin_m == MARGIN_M
    assert isinstance(
        TrajectoryChecker(talos).check(plan.step.trajectory, scene, plan.step.concessions), CheckedTrajectory
    )


def test_where_there_is_none_it_goes_as_near_as_it_may(talos, stance, ball):
    goal = straight(talos)[-1]
    hand = talos.frame_pose(goal, "tcp_right")[:3, 3]
    before_it = replace(ball, world_T_object=poses.translation(*hand))
    while is_near(talos, before_it, [goal], MARGIN_M + 0.003):
        place = before_it.world_T_object @ poses.translation(0.002, 0.0, 0.0)
        before_it = replace(before_it, world_T_object=place)
    assert is_near(talos, before_it, [goal], 2.0 * MARGIN_M)

    scene = PlanningScene().with_object(before_it)
    plan = MotionPlanner(talos).answer(MoveRequest(talos.q_home, stance, scene, GOAL, keep_others=True))

    assert isinstance(plan, MovePlan)


def test_furniture_and_what_is_near_at_the_start_keep_their_margins(talos, stance):
    at_a_finger = talos.frame_pose(talos.q_home, "tcp_right") @ poses.translation(0.087, -0.058, 0.0)
    near = SceneObject("near", Ball(0.05), at_a_finger, margin_m=MARGIN_M)
    assert is_near(talos, near, [talos.q_home], 2.0 * MARGIN_M)
    far = SceneObject("far", Ball(0.04), poses.translation(1.0, 0.0, 0.5), margin_m=MARGIN_M)
    wall = replace(far, name="wall", shape=Box((0.1, 1.0, 1.0)), movable=False)

    wide = wide_berth(talos, PlanningScene().with_objects([near, far, wall]), talos.q_home, 0.0).objects

    assert wide["far"].margin_m == MARGIN_M + BERTH_M
    assert wide["wall"].margin_m == MARGIN_M
    assert MARGIN_M <= wide["near"].margin_m < MARGIN_M + BERTH_M
