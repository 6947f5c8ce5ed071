import numpy as np
import pytest

from robots.control.loop.state_history import StateHistory
from robots.interface.robot import RobotState
from robots.interface.sensed_state import SensedState


def state(stamp_s):
    nothing = np.zeros(3)
    readings = RobotState(stamp_s, nothing, nothing, nothing, nothing, nothing, np.zeros((2, 6)))
    return SensedState(readings, lambda: nothing)


@pytest.mark.parametrize(
    ("asked_s", "found_s"),
    [(0.0, 0.0), (0.0051, 0.006), (0.0049, 0.004), (0.3, 0.4), (0.1, 0.008), (0.403, 0.402), (9.0, 0.404)],
)
def test_the_nearest_state_is_found_even_where_periods_were_skipped(asked_s, found_s):
    history = StateHistory(state(0.0), 0.002)
    for stamp_s in (0.002, 0.004, 0.006, 0.008, 0.4, 0.402, 0.404):
        history.add(state(stamp_s))

    assert history.state_at(asked_s).readings.stamp_s == found_s


def test_it_remembers_at_least_a_second_and_not_for_ever():
    history = StateHistory(state(0.0), 0.002)
    for k in range(1, 5000):
        history.add(state(k * 0.002))

    newest_s = history.state().readings.stamp_s
    assert newest_s - history.state_at(0.0).readings.stamp_s == pytest.approx(2.0, abs=0.01)
