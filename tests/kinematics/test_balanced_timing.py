import numpy as np
import pytest

from kinematics.balanced_timing import ZMP_RESERVE_M, time_in_balance, zmp_margin_m
from kinematics.curves import PolynomialCurve
from kinematics.free_coordinates import FreeCoordinates
from kinematics.scene import PlanningScene
from kinematics.timing import Pace, time_curve
from kinematics.trajectory_check import TrajectoryChecker


@pytest.fixture
def bow(talos, stance):
    """A deep, quick bow: at full pace it would tip the robot over."""
    space = FreeCoordinates(talos, stance)
    start = space.from_q(talos.q_home)
    goal = start.copy()
    goal[0] -= 0.03
    goal[4] += 0.35
    for side in ("left", "right"):
        goal[space.index(f"arm_{side}_4_joint")] += 0.5
    return space, PolynomialCurve(np.array([start, goal]))


@pytest.mark.requirement("M4")
def test_a_motion_that_would_tip_the_robot_is_slowed_down_until_it_does_not(talos, stance, bow):
    space, curve = bow
    fast = time_curve(talos, space, stance, curve, Pace())

    slow = time_in_balance(talos, space, stance, curve, Pace())

    assert zmp_margin_m(talos, fast) < 0.0
    assert slow is not None
    assert zmp_margin_m(talos, slow) >= ZMP_RESERVE_M
    assert slow.duration_s > fast.duration_s


def test_what_is_in_balance_keeps_its_pace(talos, stance):
    space = FreeCoordinates(talos, stance)
    start = space.from_q(talos.q_home)
    goal = start.copy()
    goal[space.index("head_1_joint")] += 0.3
    curve = PolynomialCurve(np.array([start, goal]))

    timed = time_in_balance(talos, space, stance, curve, Pace(0.5, 0.7))

    assert timed.duration_s == time_curve(talos, space, stance, curve, Pace(0.5, 0.7)).duration_s


def test_the_checker_sees_the_zmp_where_the_planner_sees_it(talos, stance, bow):
    space, curve = bow
    fast = time_curve(talos, space, stance, curve, Pace())

    findings = TrajectoryChecker(talos).check(fast, PlanningScene()).findings

    worst = min(item.value for item in findings if item.subject == "ZMP")
    assert worst == pytest.approx(zmp_margin_m(talos, fast), abs=0.01)
