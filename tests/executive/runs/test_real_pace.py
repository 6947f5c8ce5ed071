"""Simulated time that waits for the wall's."""

import pytest

from executive.runs.real_pace import RealPace
from executive.session.lockstep import PERIODS_A_TICK
from robots.control.period import PERIOD_S

TICK_S = PERIOD_S * PERIODS_A_TICK


class Wall:
    """A clock that computing and waiting let pass."""

    def __init__(self):
        self.now, self.slept = 100.0, []

    def now_s(self):
        return self.now

    def sleep(self, seconds):
        self.slept.append(seconds)
        self.now += max(seconds, 0.0)


def run(computing_s, ticks=10):
    wall = Wall()
    pace = RealPace(wall)
    for _ in range(ticks * PERIODS_A_TICK):
        wall.now += computing_s / PERIODS_A_TICK
        pace()
    return wall


@pytest.mark.requirement("U1")
def test_a_fast_machine_waits_for_the_rest_of_each_tick():
    wall = run(0.25 * TICK_S)

    assert wall.now == pytest.approx(100.0 + 0.25 * TICK_S + 9 * TICK_S)
    assert len(wall.slept) == 10


@pytest.mark.requirement("U1")
def test_a_slow_machine_is_not_hurried_afterwards():
    wall = run(2.0 * TICK_S)

    assert wall.now == pytest.approx(100.0 + 20.0 * TICK_S)
    assert max(wall.slept) <= 1e-12
