"""Trunk, arms and head as a person jogs them."""

import numpy as np
import pytest

from kinematics.following.jog_reference import HandJog, JointJog
from kinematics.following.jog_tracker import TICK_S, JogTracker
from kinematics.model.standing_robot import StandingRobot

TIMES = 0.002 * np.arange(1, 6)
BRAKED_TICKS = 16
"""Silence rests within 0.16 s: 0.08 s of braking and the mean over 0.072 s."""


class Anything:
    def points_are_free(self, _x):
        return True

    def why_not(self, _x):
        return None


class Wall:
    """Postures beyond a value of one coordinate are not free."""

    def __init__(self, column, most):
        self.column, self.most = column, most

    def points_are_free(self, x):
        return bool((x[:, self.column] <= self.most).all())

    def why_not(self, x):
        return None if x[self.column] <= self.most else "the wall is near"


@pytest.fixture
def robot(talos, stance):
    return StandingRobot(talos, stance)


def hand(linear, angular=(0.0, 0.0, 0.0), frame="world"):
    return HandJog("right", frame, np.array(linear), np.array(angular))


def jogged(tracker, jog, ticks):
    samples = []
    for _ in range(ticks):
        samples += tracker.tick(jog, TIMES)
    return samples


def tcp(model, q):
    return model.frame_pose(q, model.description.tcp_frames["right"])


@pytest.mark.parametrize("way", [(0.04, 0.0, 0.0), (0.0, 0.04, 0.0), (0.0, 0.0, 0.04), (0.0, 0.0, -0.04)])
def test_the_hand_goes_the_way_that_is_asked_for_and_keeps_its_direction(talos, robot, way):
    tracker = JogTracker(robot, talos.q_home, Anything())
    before = tcp(talos, talos.q_home)

    jogged(tracker, hand(way), 100)
    jogged(tracker, None, BRAKED_TICKS)

    after = tcp(talos, tracker.q)
    gone = after[:3, 3] - before[:3, 3]
    assert gone @ np.array(way) / 0.04 == pytest.approx(0.04, rel=0.15)
    assert np.linalg.norm(gone - gone @ np.array(way) * np.array(way) / 0.04**2) < 0.002
    assert np.trace(before[:3, :3].T @ after[:3, :3]) > 3.0 - 1e-4


def test_the_tools_own_axes_turn_with_it(talos, robot):
    tracker = JogTracker(robot, talos.q_home, Anything())
    before = tcp(talos, talos.q_home)

    jogged(tracker, hand((0.03, 0.0, 0.0), frame="tool"), 80)

    gone = tcp(talos, tracker.q)[:3, 3] - before[:3, 3]
    assert gone @ before[:3, 0] == pytest.approx(np.linalg.norm(gone), rel=1e-2)


def test_silence_rests_within_a_sixth_of_a_second(talos, robot):
    tracker = JogTracker(robot, talos.q_home, Anything())
    jogged(tracker, hand((0.0, 0.3, 0.0), (0.0, 0.0, 1.0)), 60)

    jogged(tracker, None, BRAKED_TICKS)

    assert tracker.at_rest


@pytest.mark.requirement("S1")
def test_setpoints_keep_acceleration_and_jerk_and_fit_together(talos, robot):
    tracker, rng = JogTracker(robot, talos.q_home, Anything()), np.random.default_rng(3)
    samples = []
    for _ in range(25):
        jog = hand(rng.uniform(-0.3, 0.3, 3), rng.uniform(-1.0, 1.0, 3))
        samples += jogged(
            tracker, rng.choice([jog, JointJog("head_1_joint", 1.0), None]), rng.integers(1, 25)
        )
    q = np.array([sample.q[7:] for sample in samples])
    v = np.array([sample.v[6:] for sample in samples])

    a = np.diff(v, axis=0) / 0.002

    assert np.abs(np.diff(q, axis=0) - 0.5 * 0.002 * (v[1:] + v[:-1])).max() < 1e-6
    assert (np.abs(a) <= talos.acceleration).all()
    assert (np.abs(np.diff(a, axis=0)) / 0.002 <= talos.jerk).all()


def test_what_is_near_slows_down_is_named_and_never_met(talos, robot):
    from kinematics.standing.free_coordinates import free_coordinates

    space = free_coordinates(robot)
    column = space.index("arm_right_4_joint")
    most = space.from_q(talos.q_home)[column] + 0.1
    tracker = JogTracker(robot, talos.q_home, Wall(column, most))

    samples = jogged(tracker, JointJog("arm_right_4_joint", 0.3), 300)

    k = talos.joints.index("arm_right_4_joint")
    gone = max(sample.q[7 + k] for sample in samples)
    assert most - 0.012 < gone <= most
    assert tracker.held_back == "the wall is near"


def test_from_where_it_was_held_back_the_opposite_leads_away(talos, robot):
    from kinematics.standing.free_coordinates import free_coordinates

    space = free_coordinates(robot)
    column = space.index("arm_right_4_joint")
    most = space.from_q(talos.q_home)[column] + 0.1
    tracker = JogTracker(robot, talos.q_home, Wall(column, most))
    jogged(tracker, JointJog("arm_right_4_joint", 0.3), 300)

    jogged(tracker, JointJog("arm_right_4_joint", -0.3), 30)

    assert tracker.held_back == ""
    assert tracker.q[7 + talos.joints.index("arm_right_4_joint")] < most - 0.05


class Slot:
    """Postures are free that leave one coordinate where it is."""

    def __init__(self, column, at):
        self.column, self.at = column, at

    def points_are_free(self, x):
        return bool((np.abs(x[:, self.column] - self.at) <= 1e-3).all())

    def why_not(self, x):
        return None if self.points_are_free(x[None]) else "the trunk is near"


@pytest.mark.parametrize("way", [(0.0, 0.04, 0.0), (0.0, -0.04, 0.0), (0.0, 0.0, 0.04), (0.0, 0.0, -0.04)])
@pytest.mark.parametrize("joint", ["torso_1_joint", "arm_right_3_joint", "arm_right_4_joint"])
def test_a_joint_that_leads_into_what_is_near_both_ways_rests_and_the_others_move_the_hand(
    talos, robot, joint, way
):
    from kinematics.standing.free_coordinates import free_coordinates

    space = free_coordinates(robot)
    column = space.index(joint)
    tracker = JogTracker(robot, talos.q_home, Slot(column, space.from_q(talos.q_home)[column]))
    before = tcp(talos, talos.q_home)

    samples = jogged(tracker, hand(way), 100)

    moved = tcp(talos, samples[-1].q)[:3, 3] - before[:3, 3]
    assert moved @ way / np.linalg.norm(way) > 0.01
    assert (
        abs(samples[-1].q[7 + talos.joints.index(joint)] - talos.q_home[7 + talos.joints.index(joint)])
        <= 1e-3
    )


def test_the_end_of_a_range_is_named_and_not_reached(talos, robot):
    tracker = JogTracker(robot, talos.q_home, Anything())

    jogged(tracker, JointJog("arm_right_7_joint", 0.3), 1500)

    k = talos.joints.index("arm_right_7_joint")
    assert tracker.q[7 + k] < talos.upper_rad[k] - talos.description.planning_margin_rad
    assert tracker.held_back == "arm_right_7_joint is near the end of its range"


def test_a_stretched_arm_is_named(talos, robot):
    tracker = JogTracker(robot, talos.q_home, Anything())

    jogged(tracker, hand((0.15, -0.1, -0.1)), 1000)

    assert tracker.held_back


def test_a_tick_is_ten_milliseconds():
    assert pytest.approx(TIMES[-1]) == TICK_S


class Pushed:
    """Something that is met by whatever turns one joint up."""

    def __init__(self, model, joint):
        self.k, self.told = model.joints.index(joint), "something is met"
        self.easing = np.zeros(len(model.joints))
        self.met = True

    def presses(self, rates):
        return self.met and rates[self.k] > 0.0


def test_what_presses_on_gives_way_to_its_end_and_the_opposite_way_is_free(talos, robot):
    joint, pushed = "arm_right_4_joint", Pushed(talos, "arm_right_4_joint")
    tracker = JogTracker(robot, talos.q_home, Anything(), pushed)
    pushed.easing[pushed.k] = -0.02

    def rad():
        return tracker.q[7 + pushed.k]

    began = rad()
    jogged(tracker, JointJog(joint, 0.2), 40)
    eased, pushed.met, said = rad(), False, tracker.held_back
    pushed.easing[:] = 0.0
    jogged(tracker, JointJog(joint, 0.2), 40)
    rested, pushed.met = rad(), True
    jogged(tracker, JointJog(joint, -0.2), 40)

    assert said == "something is met"
    assert eased == pytest.approx(began - 0.02 * 0.4, abs=0.001)
    assert rested == pytest.approx(eased, abs=0.001)
    assert rad() < rested - 0.05


def test_once_the_key_was_let_go_it_may_press_again_where_nothing_is_felt_any_more(talos, robot):
    joint, pushed = "arm_right_4_joint", Pushed(talos, "arm_right_4_joint")
    tracker = JogTracker(robot, talos.q_home, Anything(), pushed)
    jogged(tracker, JointJog(joint, 0.2), 10)
    began, pushed.met = tracker.q[7 + pushed.k], False

    jogged(tracker, None, BRAKED_TICKS)
    jogged(tracker, JointJog(joint, 0.2), 40)

    assert tracker.q[7 + pushed.k] > began + 0.05
