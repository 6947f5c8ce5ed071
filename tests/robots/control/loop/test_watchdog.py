"""Silence of the commander is noticed in time, and only while something is under way."""

import pytest

from robots.clock import ManualClock
from robots.control.loop.watchdog import CHECK_EVERY_S, SILENCE_S, Watchdog


class Watched:
    def __init__(self):
        self.clock = ManualClock()
        self.dog = Watchdog(self.clock)

    def run(self, seconds, under_way=True, beat_every_s=None):
        """Let time pass in control periods; returns when the watchdog first barked, and what it said."""
        for k in range(round(seconds / 0.002)):
            self.clock.advance(0.002)
            if beat_every_s is not None and k % round(beat_every_s / 0.002) == 0:
                self.dog.feed()
            silence_s = self.dog.silence_s(under_way)
            if silence_s is not None:
                return self.clock.now_s(), silence_s
        return None


@pytest.fixture
def watched():
    return Watched()


@pytest.mark.requirement("S3")
@pytest.mark.parametrize("offset_s", [0.0, 0.002, 0.05, 0.098])
def test_silence_is_noticed_between_one_second_and_one_look_later(watched, offset_s):
    watched.run(3.0 + offset_s, beat_every_s=0.02)
    last_s = watched.clock.now_s()
    watched.dog.feed()

    barked_s, silence_s = watched.run(2.0)

    assert SILENCE_S - 1e-6 <= barked_s - last_s <= SILENCE_S + CHECK_EVERY_S + 1e-6
    assert silence_s >= SILENCE_S - 1e-6


@pytest.mark.requirement("S3")
def test_heartbeats_keep_it_quiet(watched):
    assert watched.run(20.0, beat_every_s=0.9) is None


def test_nobody_needs_to_say_anything_while_nothing_is_under_way(watched):
    assert watched.run(20.0, under_way=False) is None


def test_what_begins_after_a_long_rest_has_its_whole_second(watched):
    watched.run(20.0, under_way=False)
    began_s = watched.clock.now_s()

    barked_s, _ = watched.run(3.0)

    assert barked_s - began_s >= SILENCE_S - 1e-6


def test_it_barks_once_for_each_silence(watched):
    first_s, _ = watched.run(3.0)
    second_s, _ = watched.run(3.0)

    assert second_s - first_s >= SILENCE_S - 1e-6
