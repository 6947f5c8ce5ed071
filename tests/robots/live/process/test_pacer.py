"""Periods that are late are counted and caught up with, up to a bound."""

import pytest

from robots.live.process.pacer import MAX_CATCH_UP_S, Pacer


class Wall:
    """Wall time that passes in sleeps, and when the test says so."""

    def __init__(self):
        self.t_s, self.slept_s = 100.0, 0.0

    def now_s(self):
        return self.t_s

    def sleep(self, seconds):
        if seconds > 0.0:
            self.t_s += seconds
            self.slept_s += seconds


def test_in_time_it_waits_for_every_period():
    wall = Wall()
    pacer = Pacer(wall, 0.002)

    assert [pacer.wait() for _ in range(500)] == [0] * 500
    assert wall.slept_s == pytest.approx(1.0)
    assert pacer.lateness().late == 0


@pytest.mark.requirement("F4")
@pytest.mark.parametrize(("late_s", "missed"), [(0.001, 0), (0.0021, 1), (0.0871, 43)])
def test_what_was_missed_is_told_once(late_s, missed):
    wall = Wall()
    pacer = Pacer(wall, 0.002)
    pacer.wait()

    wall.t_s += 0.002 + late_s

    assert pacer.wait() == missed
    assert pacer.wait() == 0
    assert pacer.lateness().worst_ms == pytest.approx(1e3 * late_s)


@pytest.mark.requirement("F4")
def test_what_nobody_could_catch_up_with_is_lost_and_told():
    wall = Wall()
    pacer = Pacer(wall, 0.002)

    wall.t_s += 3.0

    assert pacer.wait() == round(MAX_CATCH_UP_S / 0.002)
    assert pacer.wait() == 0
    assert pacer.lateness().lost_s == pytest.approx(3.0 - MAX_CATCH_UP_S, abs=0.01)


def test_a_slower_pace_takes_longer_and_no_pace_does_not_wait():
    wall = Wall()
    pacer = Pacer(wall, 0.002, pace=0.5)
    for _ in range(100):
        pacer.wait()
    assert wall.slept_s == pytest.approx(0.4)

    pacer.set_pace(0.0)
    assert [pacer.wait() for _ in range(10)] == [0] * 10
    assert wall.slept_s == pytest.approx(0.4)


def test_the_histogram_has_every_period():
    wall = Wall()
    pacer = Pacer(wall, 0.002)
    for _ in range(90):
        pacer.wait()
    for _ in range(10):
        wall.t_s += 0.0025
        pacer.wait()

    lateness = pacer.lateness()
    assert lateness.periods == 100 == sum(count for _, count in lateness.histogram)
    assert lateness.p50_ms <= 0.01
    assert lateness.p99_ms >= 0.4


@pytest.mark.requirement("F4")
def test_a_machine_that_is_always_late_is_not_caught_up_with_but_for_a_fifth_of_the_time():
    wall = Wall()
    pacer = Pacer(wall, 0.002)
    caught_up, periods = 0, 2000

    for _ in range(periods):
        wall.t_s += 0.03
        caught_up += pacer.wait()

    assert 0.15 * periods < caught_up < 0.3 * periods
    assert pacer.lateness().lost_s > 0.8 * 0.028 * periods


def test_time_that_was_held_is_no_lateness():
    wall = Wall()
    pacer = Pacer(wall, 0.002, 0.5)
    pacer.wait()

    pacer.hold(0.3)

    assert pacer.wait() == 0
    assert pacer.lateness().held_s == pytest.approx(0.15)
    assert pacer.lateness().lost_s == 0.0
