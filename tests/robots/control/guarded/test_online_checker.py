"""A setpoint of a guarded motion is refused for what is wrong with it."""

import numpy as np
import pytest

from robots.control.gate.refusal import Limit
from robots.control.guarded.guarded_motion import MotionBounds
from robots.control.guarded.online_checker import OnlineChecker
from robots.interface.robot import RobotState

JOINTS = ("a", "b")


def judged(q=(0.0, 0.0), v=(0.0, 0.0), effort=(0.0, 0.0)):
    ones = np.ones(2)
    bounds = MotionBounds(JOINTS, -ones, ones, ones, ones, 5.0)
    state = RobotState(
        0.0, np.zeros(2), np.zeros(2), np.array(effort), np.zeros(3), np.zeros(3), np.zeros((2, 6))
    )
    return OnlineChecker(bounds, np.arange(2)).judge(0.1, np.array(q), np.array(v), state)


@pytest.mark.parametrize("what", ["q", "v", "effort"])
@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_what_is_no_number_is_told_as_that_and_as_no_limit(what, value):
    refusal = judged(**{what: (0.0, value)})

    assert (refusal.limit, refusal.joint) == (Limit.NOT_FINITE, "b")


@pytest.mark.parametrize(
    ("what", "limit"),
    [("q", Limit.POSITION), ("v", Limit.VELOCITY), ("effort", Limit.MEASURED_EFFORT)],
)
def test_what_is_out_of_its_bounds_is_told_with_both_numbers(what, limit):
    refusal = judged(**{what: (-1.5, 0.0)})

    assert (refusal.limit, refusal.joint, refusal.value, refusal.bound) == (limit, "a", -1.5, -1.0)


def test_the_array_of_the_wrong_size_is_the_one_that_is_told():
    refusal = judged(v=(0.0, 0.0, 0.0))

    assert (refusal.limit, refusal.value, refusal.bound) == (Limit.SHAPE, 3.0, 2.0)
