import numpy as np
import pytest

from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.collision import leg_room
from kinematics.collision.validity import validity
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.curves import PolynomialCurve
from kinematics.motion.trajectory import Trajectory
from kinematics.motion.verdict import FindingKind, Unsafe
from kinematics.planning.path_planner import LEGS_AS_AT_HOME, PathPlanner
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing.free_coordinates import free_coordinates

# A squat, turned, rolled and to the side: limits and balance are kept, and the thighs overlap by 3.6 mm.
SQUAT = np.array([-0.02, 0.05, -0.15, 0.2, 0.05, 0.3])


@pytest.fixture(scope="module")
def space(talos, stance):
    return free_coordinates(StandingRobot(talos, stance))


@pytest.fixture(scope="module")
def planner(talos, stance, space):
    return PathPlanner(talos, space, validity(StandingRobot(talos, stance), PlanningScene()))


def squatting(space, share=1.0):
    x = space.home.copy()
    x[:6] += share * SQUAT
    return x


def test_the_kernel_and_coal_agree_about_random_squats(talos, space):
    rng = np.random.default_rng(5)
    x = np.repeat(space.home[None], 150, axis=0)
    x[:, :6] += rng.uniform([-0.1, -0.15, -0.3, -0.3, -0.3, -0.5], [0.1, 0.15, 0.0, 0.3, 0.3, 0.5], (150, 6))
    q, reached = space.to_q(x)
    kernel = leg_room.leg_room(talos)
    coal = leg_room._CoalLegRoom(talos, leg_room._between_legs(talos))

    near = coal.too_near(q[reached])
    distances_m = coal.clearances_m(q[reached])

    assert 10 < near.sum() < 140
    assert np.array_equal(kernel.too_near(q[reached]), near)
    between = near & (distances_m > 0.0)
    assert kernel.clearances_m(q[reached])[between] == pytest.approx(distances_m[between], abs=1e-5)


def test_near_home_the_legs_are_apart_without_a_look(talos, space):
    rng = np.random.default_rng(6)
    x = np.repeat(space.home[None], 200, axis=0)
    x[:, :6] += LEGS_AS_AT_HOME * rng.choice([-1.0, 0.0, 1.0], (200, 6))
    q, reached = space.to_q(x)

    assert reached.all()
    assert leg_room._CoalLegRoom(talos, leg_room._between_legs(talos)).clearances_m(q).min() > 0.008


def test_a_curve_that_ends_with_touching_thighs_is_not_free(planner, space):
    there = PolynomialCurve(np.stack([space.home, squatting(space)]))
    halfway = PolynomialCurve(np.stack([space.home, squatting(space, 0.4)]))

    assert planner.curve_is_free(halfway)
    assert not planner.curve_is_free(there)
    assert planner.is_free(squatting(space)), "the planner's judge sees nothing else in the way"


def test_no_straight_line_leads_through_a_squat_in_which_the_thighs_touch(planner, space):
    assert planner.straight(space.home, squatting(space, 0.4)) is not None
    assert planner.straight(space.home, squatting(space)) is None


def test_who_stands_with_touching_thighs_may_stand_up(planner, space):
    assert planner.straight(squatting(space), space.home) is not None


@pytest.mark.requirement("S6")
def test_what_the_planner_refuses_between_the_legs_the_checker_refuses_too(talos, stance, space):
    q = np.repeat(space.to_q(squatting(space)[None])[0], 2, axis=0)
    still = Trajectory(talos.joints, stance, np.array([0.0, 0.1]), q, np.zeros((2, talos.nv)))

    answer = TrajectoryChecker(talos).check(still, PlanningScene())

    assert isinstance(answer, Unsafe)
    touching = [finding for finding in answer.findings if finding.kind is FindingKind.SELF_COLLISION]
    assert any(all("leg" in link for link in finding.subject) for finding in touching)
