import pytest
from hypothesis import given
from hypothesis import strategies as st

from robots.control.joint_tracker import JointTracker

PERIOD_S, VELOCITY, ACCELERATION = 0.002, 0.9, 40.0


@given(targets=st.lists(st.floats(-1.0, 1.0), min_size=1, max_size=4), patience=st.integers(1, 400))
def test_whatever_the_targets_the_setpoint_keeps_its_limits_and_arrives_at_rest(targets, patience):
    tracker = JointTracker(0.0, VELOCITY, ACCELERATION, PERIOD_S)

    for k, target in enumerate(targets):
        for _ in range(patience if k + 1 < len(targets) else 2000):
            q, v = tracker.q_rad, tracker.v_rad_s
            tracker.step_towards(target)
            assert abs(tracker.v_rad_s) <= VELOCITY
            assert abs(tracker.v_rad_s - v) <= ACCELERATION * PERIOD_S
            assert tracker.q_rad == pytest.approx(q + 0.5 * (v + tracker.v_rad_s) * PERIOD_S, abs=2e-9)

    assert tracker.v_rad_s == 0.0
    assert tracker.q_rad == pytest.approx(targets[-1], abs=1e-8)


@given(target=st.floats(-1.0, 1.0))
def test_from_rest_it_never_overshoots(target):
    tracker = JointTracker(0.0, VELOCITY, ACCELERATION, PERIOD_S)

    for _ in range(1000):
        tracker.step_towards(target)
        assert abs(tracker.q_rad) <= abs(target) + 1e-9


def test_at_the_target_it_does_not_stir():
    tracker = JointTracker(0.3, VELOCITY, ACCELERATION, PERIOD_S)

    tracker.step_towards(0.3)

    assert (tracker.q_rad, tracker.v_rad_s) == (0.3, 0.0)


@given(v=st.floats(-0.88, 0.88), a=st.floats(-39.0, 39.0))
def test_coming_to_rest_keeps_acceleration_and_jerk_and_ends_exactly_at_rest(v, a):
    jerk = 4000.0
    tracker = JointTracker(0.2, VELOCITY, ACCELERATION, PERIOD_S, jerk)
    tracker.v_rad_s, tracker.a_rad_s2 = v, a

    for _ in range(60):
        before_q, before_v, before_a = tracker.q_rad, tracker.v_rad_s, tracker.a_rad_s2
        tracker.step_to_rest()
        assert abs(tracker.a_rad_s2) <= ACCELERATION
        assert abs(tracker.a_rad_s2 - before_a) <= jerk * PERIOD_S
        moved = 0.5 * (before_v + tracker.v_rad_s) * PERIOD_S
        assert tracker.q_rad == pytest.approx(before_q + moved, abs=1e-12)

    assert (tracker.v_rad_s, tracker.a_rad_s2) == (0.0, 0.0)
