import itertools
import socket

import numpy as np
import pytest
import ruckig
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import CubicHermiteSpline

import kinematics.timing.curve_timing as timing
from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.curves import BlendedPolyline, PolynomialCurve, RoundedPolyline
from kinematics.motion.verdict import FindingKind
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing.free_coordinates import FreeCoordinates
from kinematics.timing.curve_timing import FOLLOWING, JointLimits, Pace, time_coordinates, time_curve

BLEND = 0.003
ARM = JointLimits(np.array([2.0, 2.0, 2.5, 2.5, 2.0, 1.8, 1.8]), np.full(7, 8.0), np.full(7, 120.0))


def same(x):
    return x


def run(points, limits=ARM, blend=BLEND):
    weights = np.ones(points.shape[1])
    return time_coordinates(BlendedPolyline(points, weights, blend), same, limits, weights)


def waypoints(seed, count=20, step=0.5, size=7):
    """A random walk."""
    steps = np.random.default_rng(seed).normal(size=(count - 1, size))
    steps *= step / np.linalg.norm(steps, axis=1, keepdims=True)
    return np.concatenate([np.zeros((1, size)), np.cumsum(steps, axis=0)])


def motion_of(timed):
    """What a trajectory means between its samples, made by somebody else."""
    return CubicHermiteSpline(timed.t_s, timed.q, timed.rate)


def away_from(polyline, points):
    """How far the farthest joint must go to come back to a polyline, shape (n,)."""
    least = np.full(len(points), np.inf)
    for a, b in itertools.pairwise(polyline):
        low, high = np.zeros(len(points)), np.ones(len(points))
        # the largest of several distances is convex along a straight piece
        for _ in range(25):
            left, right = (2 * low + high) / 3, (low + 2 * high) / 3
            gaps = [np.abs(points - a - at[:, None] * (b - a)).max(axis=1) for at in (left, right)]
            nearer = gaps[0] < gaps[1]
            low, high = np.where(nearer, low, left), np.where(nearer, right, high)
        least = np.minimum(least, np.minimum(*gaps))
    return least


def stop_and_go_s(points, limits):
    """How long it takes with a stop at every corner."""
    total = 0.0
    for a, b in itertools.pairwise(points):
        way = np.abs(b - a) + 1e-12
        request = ruckig.InputParameter(1)
        request.target_position = [1.0]
        request.max_velocity = [float(np.min(limits.velocity / way))]
        request.max_acceleration = [float(np.min(limits.acceleration / way))]
        request.max_jerk = [float(np.min(limits.jerk / way))]
        profile = ruckig.Trajectory(1)
        ruckig.Ruckig(1).calculate(request, profile)
        total += profile.duration
    return total


def random_curve(talos, stance, seed, corners=(1, 4)):
    rng = np.random.default_rng(seed)
    space = FreeCoordinates(StandingRobot(talos, stance))
    start = space.from_q(talos.q_home)
    points = [start]
    for _ in range(int(rng.integers(*corners))):
        step = np.concatenate([rng.uniform(-0.02, 0.02, 6), rng.uniform(-0.4, 0.4, space.size - 6)])
        points.append(start + step)
    return space, RoundedPolyline(np.array(points), space.weights, 0.12)


# ---------------------------------------------------------------- any coordinates


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 10_000), st.integers(2, 25), st.sampled_from([0.02, 0.1, 0.5, 2.0]))
def test_every_limit_holds_at_every_instant(seed, count, step):
    motion = motion_of(run(waypoints(seed, count, step)))

    t = np.linspace(0.0, motion.x[-1], 8 * len(motion.x))
    assert np.all(np.abs(motion(t, 1)) <= ARM.velocity * (1 + 1e-5))
    accelerations = np.concatenate([motion(t, 2), motion.derivative(2)(motion.x)])
    assert np.all(np.abs(accelerations) <= ARM.acceleration * (1 + 1e-5))
    assert np.all(np.abs(motion(t, 3)) <= ARM.jerk * (1 + 1e-5))


@given(st.integers(0, 10_000))
@settings(max_examples=20, deadline=None)
def test_acceleration_does_not_step_between_two_cubics(seed):
    motion = motion_of(run(waypoints(seed)))

    late = motion.derivative(2)(motion.x[1:-1] - 1e-12)
    early = motion.derivative(2)(motion.x[1:-1])
    assert np.all(np.abs(early - late) <= ARM.jerk * np.diff(motion.x)[0] * (1 + 1e-5))


@settings(max_examples=10, deadline=None)
@given(st.integers(0, 10_000), st.sampled_from([0.05, 0.3, 1.0]))
def test_no_joint_leaves_the_polyline_by_more_than_blend_and_following(seed, step):
    points = waypoints(seed, step=step)
    motion = motion_of(run(points))

    away = away_from(points, motion(np.linspace(0.0, motion.x[-1], 1500)))

    assert away.max() <= BLEND + FOLLOWING + 1e-6


def test_a_narrower_following_is_kept_and_costs_time(monkeypatch):
    points = waypoints(3)
    wide = run(points)
    monkeypatch.setattr(timing, "FOLLOWING", 0.002)

    narrow = run(points)

    away = away_from(points, motion_of(narrow)(np.linspace(0.0, narrow.t_s[-1], 1500)))
    assert away.max() <= BLEND + 0.002 + 1e-6
    assert away_from(points, wide.q).max() > BLEND + 0.002
    assert narrow.t_s[-1] > wide.t_s[-1]


def test_a_straight_motion_takes_the_fastest_ramps_and_one_window():
    limits = JointLimits(np.array([1.0]), np.array([4.0]), np.array([80.0]))
    length, window_s = 2.0, 2.0 * 4.0 / 80.0

    timed = run(np.array([[0.0], [length]]), limits)

    reserve = 1.0 - 16.0 / 27.0 * timing.SAMPLE_S / window_s
    expected = length / 1.0 + 1.0 / (4.0 * reserve) + window_s
    assert timed.t_s[-1] == pytest.approx(expected, rel=2e-3)


@pytest.mark.parametrize("seed", range(5))
def test_a_path_of_twenty_waypoints_does_not_stop_at_its_corners(seed):
    points = waypoints(seed)

    timed = run(points)

    speed = np.linalg.norm(timed.rate, axis=1)
    assert speed[10:-10].min() > 0.1
    assert stop_and_go_s(points, ARM) / timed.t_s[-1] > 1.10


def test_a_motion_along_a_straight_piece_stays_on_it():
    points = np.array([[0.0, 0.0], [0.4, 0.3], [1.2, 0.9]])

    timed = run(points, JointLimits(ARM.velocity[:2], ARM.acceleration[:2], ARM.jerk[:2]))

    assert timed.q[:, 1] == pytest.approx(0.75 * timed.q[:, 0], abs=1e-12)


def test_turning_back_passes_the_end_at_rest_and_stays_within_limits():
    limits = JointLimits(np.array([1.0]), np.array([4.0]), np.array([80.0]))

    timed = run(np.array([[0.0], [0.5], [0.1]]), limits)

    assert 0.5 - BLEND - FOLLOWING <= timed.q.max() <= 0.5
    assert np.abs(motion_of(timed)(timed.t_s, 2)).max() <= 4.0 * (1 + 1e-5)


def test_nothing_to_move_takes_a_moment():
    timed = run(np.array([[0.1, 0.2], [0.1, 0.2]]), JointLimits(*(limit[:2] for limit in limits_of(ARM))))

    assert timed.t_s[-1] < 0.3
    assert timed.q == pytest.approx(np.tile([0.1, 0.2], (len(timed.q), 1)))


def limits_of(limits):
    return limits.velocity, limits.acceleration, limits.jerk


def test_the_same_curve_gives_the_same_bits():
    first, second = (run(waypoints(7)) for _ in range(2))

    assert np.array_equal(first.q, second.q)
    assert np.array_equal(first.rate, second.rate)


def test_joints_that_follow_in_another_way_are_slowed_down_until_their_limits_hold():
    """The second joint is not a coordinate: it depends on the first, and moves up to 6 times as fast."""
    limits = JointLimits(np.array([2.0, 2.0]), np.array([8.0, 8.0]), np.array([120.0, 120.0]))

    def geared(x):
        return np.column_stack([x[:, 0], 0.2 * np.sin(15.0 * x[:, 0]) + 3.0 * x[:, 0]])

    curve = PolynomialCurve(np.array([[0.0], [1.0]]))
    timed = time_coordinates(curve, geared, limits, np.ones(1))

    motion = motion_of(timed)
    t = np.linspace(0.0, timed.t_s[-1], 8 * len(timed.t_s))
    for order, limit in ((1, 2.0), (2, 8.0), (3, 120.0)):
        assert np.abs(motion(t, order)).max() <= limit * (1 + 1e-5)


# ---------------------------------------------------------------- a standing robot


@pytest.mark.parametrize("seed", range(8))
def test_the_checker_has_nothing_against_how_a_curve_is_timed(talos, stance, seed):
    _space, curve = random_curve(talos, stance, seed)

    trajectory = time_curve(StandingRobot(talos, stance), curve, Pace(jerk=1.0))

    answer = TrajectoryChecker(talos).check(trajectory, PlanningScene())
    found = {finding.kind for finding in getattr(answer, "findings", ())}
    # where the random curve goes, and what it does to the balance, is not the timing's choice
    assert found <= {FindingKind.POSITION_LIMIT, FindingKind.SELF_COLLISION, FindingKind.BALANCE}


@pytest.mark.parametrize("seed", range(8))
def test_every_joint_stays_inside_its_limits(talos, stance, seed):
    _space, curve = random_curve(talos, stance, seed)

    trajectory = time_curve(StandingRobot(talos, stance), curve, Pace(jerk=1.0))

    dt = np.diff(trajectory.t_s)[:, None]
    v = trajectory.v[:, 6:]
    acceleration = np.diff(v, axis=0) / dt
    jerk = np.diff(acceleration, axis=0) / dt[:-1]
    assert np.all(np.abs(v) <= talos.velocity * (1 + 1e-5))
    assert np.all(np.abs(acceleration) <= talos.acceleration * (1 + 1e-5))
    assert np.all(np.abs(jerk) <= talos.jerk * (1 + 1e-5))
    assert np.all(trajectory.v[[0, -1]] == 0.0)


def test_the_feet_stay_where_they_are(talos, stance):
    _space, curve = random_curve(talos, stance, 4)

    trajectory = time_curve(StandingRobot(talos, stance), curve, Pace())

    assert np.ptp(trajectory.q[:, 2]) > 1e-3
    for q in trajectory.q[::10]:
        for frame, world_T_sole in stance.soles:
            assert talos.frame_pose(q, frame) == pytest.approx(world_T_sole, abs=1e-9)


def test_it_begins_and_ends_where_the_curve_does(talos, stance):
    space, curve = random_curve(talos, stance, 5)

    trajectory = time_curve(StandingRobot(talos, stance), curve, Pace())

    ends = space.to_q(curve(np.array([0.0, 1.0])))[0]
    assert np.array_equal(trajectory.q[[0, -1]], ends)


def test_velocities_are_the_derivative_of_the_configurations(talos, stance):
    import pinocchio as pin

    _space, curve = random_curve(talos, stance, 1)
    trajectory = time_curve(StandingRobot(talos, stance), curve, Pace())

    for k in range(10, len(trajectory.t_s) - 10, 7):
        dt = trajectory.t_s[k + 1] - trajectory.t_s[k - 1]
        numeric = pin.difference(talos.pin, trajectory.q[k - 1], trajectory.q[k + 1]) / dt
        assert trajectory.v[k] == pytest.approx(numeric, abs=5e-3)


def test_a_slower_pace_takes_longer_and_keeps_the_geometry(talos, stance):
    _space, curve = random_curve(talos, stance, 2)

    fast = time_curve(StandingRobot(talos, stance), curve, Pace())
    slow = time_curve(StandingRobot(talos, stance), curve, Pace(velocity=0.2, acceleration=0.2))

    assert slow.duration_s > 1.5 * fast.duration_s
    assert slow.q[-1] == pytest.approx(fast.q[-1])


def test_legs_that_cannot_follow_give_no_trajectory(talos, stance):
    space = FreeCoordinates(StandingRobot(talos, stance))
    start = space.from_q(talos.q_home)
    goal = start.copy()
    goal[2] += 0.3

    curve = RoundedPolyline(np.array([start, goal]), space.weights, 0.12)

    assert time_curve(StandingRobot(talos, stance), curve, Pace()) is None


def test_timing_opens_no_socket(talos, stance, monkeypatch):
    def refuse(*arguments, **options):
        raise AssertionError("a socket was opened")

    monkeypatch.setattr(socket, "socket", refuse)
    _space, curve = random_curve(talos, stance, 3)

    assert time_curve(StandingRobot(talos, stance), curve, Pace()).duration_s > 0.0
