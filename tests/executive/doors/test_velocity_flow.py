"""Velocities on their way to a served robot."""

import math
import time

import pytest

from executive.doors.velocity_flow import VelocityFlow

pytestmark = pytest.mark.requirement("U3")


@pytest.fixture
def told():
    return []


@pytest.fixture
def flow(served, told):
    made = VelocityFlow(served.folder.path, told.append)
    yield made
    made.close()


def until(flow, condition):
    for _ in range(2000):
        flow.poll(0.0)
        if condition():
            return
        time.sleep(0.002)
    raise AssertionError("it did not happen")


def test_velocities_reach_the_robot_in_their_order(served, flow):
    served.holds = True
    for speed in (0.1, 0.2, 0.3):
        flow.hear(speed, 0.0, 0.0)

    until(flow, lambda: len(served.velocities) == 3)
    assert [one[0] for one in served.velocities] == [0.1, 0.2, 0.3]


def test_what_was_refused_is_not_sent_again_at_once(served, flow, told):
    served.refuses = True
    flow.hear(0.9, 0.0, 0.0)
    until(flow, lambda: "refused: too fast" in told)
    for now_s in (0.1, 0.5, 0.9):
        flow.hear(0.9, 0.0, now_s)
    assert len(served.said) == 1
    flow.hear(0.9, 0.0, 1.1)

    until(flow, lambda: len(served.said) == 2)


def test_standing_still_begins_nothing(served, flow):
    flow.hear(0.0, 0.0, 0.0)
    flow.poll(0.0)

    assert served.said == []


@pytest.mark.parametrize("velocity", [(math.nan, 0.0), (0.0, math.inf)])
def test_what_is_no_number_is_refused_and_sent_to_nobody(served, flow, told, velocity):
    flow.hear(*velocity, 0.0)

    assert told[0].startswith("refused: this robot cannot go")
    assert served.velocities == []


def test_where_nobody_serves_it_is_told(tmp_path, told):
    VelocityFlow(tmp_path, told.append).hear(0.1, 0.0, 0.0)

    assert told[0].startswith("refused: ")


def test_what_the_robot_cannot_do_is_refused_with_the_reason(served, flow, told):
    flow.hear(0.1, 0.0, 0.0, "it does not walk sideways")

    assert told == ["refused: it does not walk sideways"]
    assert served.velocities == []
