"""Pushes are told from knocks."""

import pytest

from kinematics.geometry.planar import PlanarPose
from kinematics.walking.pattern.com_motion import ComSample
from kinematics.walking.pattern.pattern_sample import PatternSample, Phase
from robots.control.walking.push_watch import PushWatch

PERIOD_S = 0.002
ZERO = (0.0, 0.0)
ON_ONE = {"left": 900.0, "right": 0.0}


def plan(*carrying):
    feet = {"left": PlanarPose(), "right": PlanarPose()}
    com = ComSample(ZERO, ZERO, ZERO, ZERO)
    return PatternSample(com, feet, {"left": 0.0, "right": 0.0}, carrying, Phase.SWING)


def test_a_knock_of_a_moment_hardly_counts_and_a_push_does():
    watch = PushWatch()

    knocked = watch.felt((0.3, 0.0), ON_ONE, plan("left"), PERIOD_S)
    for _ in range(100):
        pushed = watch.felt((0.1, -0.05), ON_ONE, plan("left"), PERIOD_S)

    assert knocked is None
    assert pushed == pytest.approx((0.1, -0.05), abs=1e-3)


def test_nothing_is_felt_while_both_feet_touch_the_floor_or_nobody_walks():
    watch = PushWatch()
    for _ in range(20):
        watch.felt((0.2, 0.0), ON_ONE, plan("left"), PERIOD_S)

    assert watch.felt((0.2, 0.0), ON_ONE, None, PERIOD_S) is None
    assert watch.felt((0.2, 0.0), ON_ONE, plan("left", "right"), PERIOD_S) is None
    assert watch.felt((0.2, 0.0), {"left": 500.0, "right": 60.0}, plan("left"), PERIOD_S) is None
    assert watch.felt((0.2, 0.0), ON_ONE, plan("left"), PERIOD_S) is not None


def test_what_any_walk_shows_is_no_push():
    watch = PushWatch()

    for _ in range(500):
        assert watch.felt((0.02, -0.02), ON_ONE, plan("left"), PERIOD_S) is None
