import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from robots.control.grip.joint_tracker import JointTracker
from robots.control.grip.rest_point import rest_point

PERIOD_S, VELOCITY, ACCELERATION, JERK = 0.002, 0.9, 40.0, 4000.0
OTHERS = [(VELOCITY, ACCELERATION, JERK), (2.0, 8.0, 120.0), (0.5, 5.0, 8000.0)]
"""Limits of a gripper, of an arm, and of one whose acceleration changes almost at once."""

targets = st.floats(-1.0, 1.0)
speeds, accelerations = st.floats(-0.88, 0.88), st.floats(-39.0, 39.0)


def tracker_at(q, v, a, velocity=VELOCITY, acceleration=ACCELERATION, jerk=JERK):
    tracker = JointTracker(q, velocity, acceleration, PERIOD_S, jerk)
    tracker.v_rad_s, tracker.a_rad_s2 = v, a
    return tracker


def rest_of(q, v, a, acceleration=ACCELERATION, jerk=JERK):
    return rest_point(q, v, a, PERIOD_S, 0.98 * acceleration, 0.98 * jerk * PERIOD_S)


def peak_speed(v, a, jerk=JERK):
    """What the speed comes to when the acceleration fades from here on."""
    change = 0.98 * jerk * PERIOD_S
    fades = np.maximum(abs(a) - change * np.arange(1, 1 + int(abs(a) / change)), 0.0)
    return abs(v + np.sign(a) * PERIOD_S * fades.sum())


class Watched:
    """A tracker of which each step is looked at."""

    def __init__(self, tracker, velocity=VELOCITY, acceleration=ACCELERATION, jerk=JERK):
        self.tracker, self.limits = tracker, (velocity, acceleration, jerk)
        self.trace = [tracker.q_rad]

    def step(self, target=None):
        tracker, (velocity, acceleration, jerk) = self.tracker, self.limits
        q, v, a = tracker.q_rad, tracker.v_rad_s, tracker.a_rad_s2
        if target is None:
            tracker.step_to_rest()
        else:
            tracker.step_towards(target)
        # What the robot sees: speeds, and differences of them.
        change = (tracker.v_rad_s - v) / PERIOD_S
        assert abs(tracker.v_rad_s) <= velocity
        assert abs(change) <= acceleration
        assert abs(change - a) <= jerk * PERIOD_S
        assert change == pytest.approx(tracker.a_rad_s2, abs=1e-3)
        assert tracker.q_rad == pytest.approx(q + 0.5 * (v + tracker.v_rad_s) * PERIOD_S, abs=2e-9)
        self.trace.append(tracker.q_rad)


@given(goals=st.lists(targets, min_size=1, max_size=4), patience=st.integers(1, 400))
@settings(max_examples=50)
def test_whatever_the_targets_the_setpoint_keeps_its_limits_and_arrives_at_rest(goals, patience):
    watched = Watched(tracker_at(0.0, 0.0, 0.0))

    for goal in goals[:-1]:
        for _ in range(patience):
            watched.step(goal)
    for _ in range(1300):
        watched.step(goals[-1])

    assert not watched.tracker.moving
    assert watched.tracker.q_rad == pytest.approx(goals[-1], abs=1e-8)


@pytest.mark.requirement("S1")
@pytest.mark.parametrize("limits", OTHERS)
@given(q=targets, v=speeds, a=accelerations, target=targets)
@settings(max_examples=25)
def test_from_any_state_it_keeps_its_limits_and_arrives_in_bounded_time(limits, q, v, a, target):
    velocity, acceleration, jerk = limits
    v, a = v * velocity / VELOCITY, a * acceleration / ACCELERATION
    assume(peak_speed(v, a, jerk) <= 0.98 * velocity)
    watched = Watched(tracker_at(q, v, a, *limits), *limits)
    back_and_forth_s = abs(v) / acceleration + acceleration / jerk
    way = abs(target - q) + 3.0 * velocity * back_and_forth_s
    longest_s = 1.1 * (way / velocity + 4.0 * (velocity / acceleration + acceleration / jerk))

    for _ in range(int(longest_s / PERIOD_S)):
        watched.step(target)

    assert not watched.tracker.moving
    assert watched.tracker.q_rad == pytest.approx(target, abs=1e-8)


@given(q=targets, v=speeds, a=accelerations, target=targets)
@settings(max_examples=50)
def test_it_never_goes_beyond_the_target_and_where_it_could_not_but_rest(q, v, a, target):
    assume(peak_speed(v, a) <= 0.98 * VELOCITY)
    watched = Watched(tracker_at(q, v, a))
    first_stop = rest_of(q, v, a)
    bounds = (min(q, target, first_stop), max(q, target, first_stop))
    # The way to the first stop may lead beyond where it began, before it turns.
    braked = Watched(tracker_at(q, v, a))
    for _ in range(60):
        braked.step()
    lower, upper = min(*bounds, *braked.trace), max(*bounds, *braked.trace)

    for _ in range(1300):
        watched.step(target)

    assert min(watched.trace) >= lower - 1e-8
    assert max(watched.trace) <= upper + 1e-8


@given(target=targets)
@settings(max_examples=50)
def test_from_rest_it_never_overshoots_nor_turns_back(target):
    watched = Watched(tracker_at(0.0, 0.0, 0.0))

    for _ in range(700):
        watched.step(target)

    way = np.sign(target) * np.diff(watched.trace)
    assert way.min() >= -1e-12
    assert abs(watched.trace[-1]) <= abs(target) + 1e-9


def test_at_the_target_it_does_not_stir():
    tracker = tracker_at(0.3, 0.0, 0.0)

    tracker.step_towards(0.3)

    assert (tracker.q_rad, tracker.v_rad_s) == (0.3, 0.0)


def test_it_takes_hardly_longer_than_the_limits_ask_for():
    watched = Watched(tracker_at(0.0, 0.0, 0.0))
    periods = 0

    while (abs(watched.tracker.q_rad - 0.7) > 1e-6 or watched.tracker.moving) and periods < 1000:
        watched.step(0.7)
        periods += 1

    least_s = 0.7 / VELOCITY + VELOCITY / ACCELERATION + ACCELERATION / JERK
    assert least_s <= periods * PERIOD_S <= 1.03 * least_s


@given(v=speeds, a=accelerations)
def test_coming_to_rest_keeps_all_limits_and_ends_exactly_at_rest_where_it_was_foreseen(v, a):
    assume(peak_speed(v, a) <= 0.98 * VELOCITY)
    watched = Watched(tracker_at(0.2, v, a))
    foreseen = watched.tracker.rest_rad

    for _ in range(60):
        watched.step()

    assert (watched.tracker.v_rad_s, watched.tracker.a_rad_s2) == (0.0, 0.0)
    assert watched.tracker.q_rad == pytest.approx(foreseen, abs=5e-9)


@given(q=targets, v=speeds, a=accelerations, more=st.floats(0.0, 7.0))
def test_the_place_of_rest_rises_with_the_acceleration(q, v, a, more):
    def rest_after(a):
        return rest_of(q + PERIOD_S * (v + 0.5 * a * PERIOD_S), v + a * PERIOD_S, a)

    assert rest_after(a + more) >= rest_after(a) - 1e-12
