"""A body over real DDS on loopback: the referee is a process of its own, the wire Cyclone DDS's."""

import subprocess
import sys

import numpy as np
import pytest

from robots.clock import WallClock
from robots.interface.robot import JointSetpoint
from robots.models.description import load_robot
from robots.unitree.body import attach
from robots.unitree.watch import Trouble

DOMAIN = 87
PERIOD_S = 0.002


@pytest.fixture
def referee():
    """Starts a referee that hangs in its harness."""
    started = []

    def start(*words):
        command = [sys.executable, "-m", "tools.unitree.referee", "--hung", "--domain", str(DOMAIN), *words]
        process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        started.append(process)
        assert process.stdout.readline() == "listening\n"
        return process

    yield start
    for process in started:
        process.kill()
        process.wait()


def hold(body, clock, until, within_s=60.0):
    """Hold home in real time until something is so; whether it came to be."""
    description = body.description
    q = np.array([description.home[name] for name in description.actuated])
    n, k, end_s = len(q), 0, clock.now_s() + within_s
    while clock.now_s() < end_s:
        k += 1
        body.command(JointSetpoint(0.0, k, "hold", q, np.zeros(n), np.zeros(n)))
        body.advance(PERIOD_S)
        if until(np.abs(body.read().q - q).max(), {one.trouble for one in body.findings}):
            return True
    return False


@pytest.mark.requirement("U8")
def test_joints_follow_over_dds_with_2_ms_of_delay_and_a_lost_percent(referee):
    referee("--delay-ms", "2", "--loss", "0.01")
    clock = WallClock()
    body = attach(load_robot("g1"), clock, {"domain": str(DOMAIN)})

    assert hold(body, clock, lambda off_rad, troubles: body.taken_up and off_rad < 0.03 and not troubles)


def test_a_cable_that_is_pulled_for_longer_than_a_second_is_lost_until_a_person_resets(referee):
    referee("--fault", "silent:2:4")
    clock = WallClock()
    body = attach(load_robot("g1"), clock, {"domain": str(DOMAIN)})

    assert hold(body, clock, lambda _off_rad, troubles: Trouble.LOST in troubles)
    assert "lost" in body.read().alarm
    assert hold(body, clock, lambda _off_rad, _troubles: body.reset() is None)
    assert hold(body, clock, lambda _off_rad, troubles: body.taken_up and not troubles)
