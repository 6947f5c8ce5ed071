"""Random and spoiled messages: no crash, no motion, and whoever speaks properly is served all the while."""

import json

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from robots.live.framing import FrameKind
from robots.live.messages import GetStatus, Heartbeat

WORDS = ["hello", "heartbeat", "start", "guarded", "cancel", "admit", "status", "reset"]
FIELDS = ["number", "stamp_s", "motion", "trajectory", "role", "name", "hand", "reason", "busy", "person"]
values = st.none() | st.booleans() | st.integers() | st.floats() | st.sampled_from(["left", "commander", ""])
spoiled = st.builds(
    lambda kind, fields: json.dumps({"type": kind, **fields}).encode(),
    st.sampled_from(WORDS),
    st.dictionaries(st.sampled_from(FIELDS), values, max_size=5),
)


@pytest.mark.requirement("F4", "F8")
@settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.lists(st.tuples(st.booleans(), st.binary(max_size=60) | spoiled), max_size=8))
def test_no_message_of_a_stranger_moves_the_robot_or_ends_the_service(live, sent):
    if not live.clients:
        live.client("commander")
    commander, stranger = live.clients[0], live.client()
    commander.say(Heartbeat(*commander.next(), False, False, False, 0))
    before = live.robot.read().q

    for framed, payload in sent:
        if framed:
            stranger.raw(payload, FrameKind.MESSAGE)
        else:
            stranger.connection._unsent += payload
            stranger.connection.flush()
        live.run(0.002)
    commander.say(GetStatus())
    live.run(0.006)

    assert (live.robot.read().q == before).all()
    assert not live.loop.statistics.checked_trajectories
    commander.listen()
    assert not commander.connection.closed
    assert commander.heard.pop()["type"] == "status"
    stranger.connection.close("")
    live.clients.remove(stranger)
    live.run(0.002)
