import numpy as np
import pytest

from kinematics.dynamics.standing_dynamics import StandingDynamics
from kinematics.motion.curves import PolynomialCurve
from kinematics.planning.planning_task import REACH_PACE, PlanningTask
from kinematics.requests.pick import PickRequest


@pytest.fixture
def at_a_limit(talos, stance, tabletop):
    """A task of a robot that rests where plans do not go: nearer to a joint limit than they do."""
    q = talos.q_home.copy()
    head = talos.joint_index("head_1_joint")
    q[7 + head] = talos.upper_rad[head] - 1e-3
    return PlanningTask(talos, PickRequest(q, stance, tabletop, "cup"), 0.0), q


def test_the_first_step_begins_where_the_robot_is(at_a_limit):
    task, q = at_a_limit

    step = task.first_step("reach", task.straight(task.space.home), REACH_PACE)

    np.testing.assert_array_equal(step.trajectory.q[0], q)


def test_a_step_that_the_legs_cannot_follow_is_none(talos, stance, tabletop):
    task = PlanningTask(talos, PickRequest(talos.q_home, stance, tabletop, "cup"), 0.0)
    up = task.x_start.copy()
    up[2] += 0.5

    assert task.step("rise", PolynomialCurve(np.stack([task.x_start, up])), REACH_PACE) is None


@pytest.mark.parametrize(("axis", "angle_rad", "stays"), [(0, 0.6, True), (0, 0.7, False), (1, -0.7, False)])
def test_what_leans_so_far_that_it_is_taken_for_a_fall_does_not_stay_up(
    axis, angle_rad, stays, talos, stance, tabletop, monkeypatch
):
    task = PlanningTask(talos, PickRequest(talos.q_home, stance, tabletop, "cup"), 0.0)
    monkeypatch.setattr(StandingDynamics, "holding_efforts", lambda _self, _q: 0.0 * talos.effort)
    q = talos.q_home.copy()
    q[3:7] = np.sin(0.5 * angle_rad) * np.eye(4)[axis] + np.cos(0.5 * angle_rad) * np.eye(4)[3]

    assert task.stays_up(q) is stays


def test_a_step_is_judged_in_the_scene_that_was_asked_about(talos, stance, tabletop):
    task = PlanningTask(talos, PickRequest(talos.q_home, stance, tabletop, "cup"), 0.0)
    turned = task.looking(task.x_start[None].copy(), {"head_1_joint": 0.2})

    step = task.step("look", PolynomialCurve(np.stack([task.x_start, turned[0]])), REACH_PACE)

    assert step.scene is tabletop
    assert step.trajectory.q[-1][7 + talos.joint_index("head_1_joint")] == pytest.approx(0.2)
