"""A joint that was stopped in the margin which plans keep from its limit is not stuck there."""

import numpy as np
import pytest

from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.verdict import CheckedTrajectory
from kinematics.motion_planner import MotionPlanner
from kinematics.requests.move import MovePlan, MoveRequest
from kinematics.requests.pick import PickPlan, PickRequest
from kinematics.scene.planning_scene import PlanningScene

NEAR_RAD = 0.003


@pytest.fixture(params=["arm_right_7_joint", "head_1_joint"])
def at_the_limit(request, talos):
    """At home but for one joint, nearer to its upper limit than plans go."""
    index = talos.joint_index(request.param)
    q = talos.q_home.copy()
    q[7 + index] = talos.upper_rad[index] - NEAR_RAD
    return q


def test_it_goes_home_and_the_checker_agrees(talos, stance, at_the_limit):
    plan = MotionPlanner(talos).answer(MoveRequest(at_the_limit, stance, PlanningScene()))

    assert isinstance(plan, MovePlan)
    trajectory = plan.step.trajectory
    assert trajectory.q[0] == pytest.approx(at_the_limit, abs=1e-9)
    assert trajectory.q[-1] == pytest.approx(talos.q_home, abs=1e-3)
    assert isinstance(TrajectoryChecker(talos).check(trajectory, PlanningScene()), CheckedTrajectory)


def test_it_picks_something_up(talos, stance, tabletop, at_the_limit):
    plan = MotionPlanner(talos).answer(PickRequest(at_the_limit, stance, tabletop, "cup"))

    assert isinstance(plan, PickPlan)
    assert plan.reach.trajectory.q[0] == pytest.approx(at_the_limit, abs=1e-9)


def test_a_start_inside_the_margins_is_left_as_it_is(talos, stance):
    from kinematics.standing.free_coordinates import free_coordinates

    space = free_coordinates(StandingRobot(talos, stance))

    assert np.array_equal(space.start(talos.q_home), space.from_q(talos.q_home))
