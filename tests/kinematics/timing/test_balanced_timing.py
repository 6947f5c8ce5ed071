import numpy as np
import pytest

from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.dynamics.zmp import balance_margins_m
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.curves import PolynomialCurve
from kinematics.motion.sampler import TrajectorySampler
from kinematics.motion.verdict import Unsafe
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing.free_coordinates import FreeCoordinates
from kinematics.timing.balanced_timing import ZMP_RESERVE_M, time_in_balance
from kinematics.timing.curve_timing import Pace, time_curve


@pytest.fixture
def sway(talos, stance):
    """A quick bow from back to ahead: at full pace it would tip the robot over."""
    space = FreeCoordinates(StandingRobot(talos, stance))
    start, goal = space.from_q(talos.q_home), space.from_q(talos.q_home)
    start[[0, 2, 4]] += (-0.05, -0.03, -0.2)
    goal[[0, 2, 4]] += (0.04, -0.03, 0.4)
    return space, PolynomialCurve(np.array([start, goal]))


def zmp_margin_m(talos, trajectory):
    sampler = TrajectorySampler(trajectory)
    motion = sampler.many(np.arange(0.0, sampler.duration_s, 0.01))
    return balance_margins_m(StandingRobot(talos, trajectory.stance), motion)[0].min()


@pytest.mark.requirement("M4")
def test_a_motion_that_would_tip_the_robot_is_slowed_down_until_it_does_not(talos, stance, sway):
    _space, curve = sway
    fast = time_curve(StandingRobot(talos, stance), curve, Pace())

    slow = time_in_balance(StandingRobot(talos, stance), curve, Pace())

    assert zmp_margin_m(talos, fast) < 0.0
    assert slow is not None
    assert zmp_margin_m(talos, slow) >= ZMP_RESERVE_M - 1e-3
    assert slow.duration_s > fast.duration_s


def test_what_is_in_balance_keeps_its_pace(talos, stance):
    space = FreeCoordinates(StandingRobot(talos, stance))
    start = space.from_q(talos.q_home)
    goal = start.copy()
    goal[space.index("head_1_joint")] += 0.3
    curve = PolynomialCurve(np.array([start, goal]))

    timed = time_in_balance(StandingRobot(talos, stance), curve, Pace(0.5, 0.7))

    assert timed.duration_s == time_curve(StandingRobot(talos, stance), curve, Pace(0.5, 0.7)).duration_s


def test_the_checker_sees_the_zmp_where_the_planner_sees_it(talos, stance, sway):
    _space, curve = sway
    fast = time_curve(StandingRobot(talos, stance), curve, Pace())

    unsafe = TrajectoryChecker(talos).check(fast, PlanningScene())

    assert isinstance(unsafe, Unsafe)
    worst = min(item.value for item in unsafe.findings if item.subject == ("ZMP",))
    assert worst == pytest.approx(zmp_margin_m(talos, fast), abs=0.01)
