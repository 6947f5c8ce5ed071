"""Random and spoiled messages: no crash, no motion, and whoever speaks properly is served all the while."""

import json

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from robots.live.wire.framing import FrameKind
from robots.live.wire.messages import GetStatus, Heartbeat, Lead, Steer, Walk, write_control_message

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


DRAWER = {"kind": "drawer", "closed_m": [0.5, 0.3, 1.0], "yaw_rad": 0.0}
ORDER = {
    "hand": "left", "objects": [], "furniture": [], "held": [], "allowed": [], "parts": [], "path": DRAWER,
    "s_from": 0.0, "s_to": 0.1, "bias": [0.0] * 6, "stop_from": None, "holding": True, "manner": "usual",
}  # fmt: skip
anything = values | st.lists(st.floats(-2.0, 2.0), max_size=4) | st.just(DRAWER) | st.just([{}])
orders = st.builds(
    lambda changed: {**ORDER, **changed}, st.dictionaries(st.sampled_from([*ORDER]), anything, max_size=3)
)
steerings = st.fixed_dictionaries(
    {"kind": st.sampled_from(["velocity", "stretch", "path"])},
    optional=dict.fromkeys(("linear_m_s", "angular_rad_s", "start", "distance_m", "path"), anything),
)


@pytest.mark.requirement("F4", "F8", "S6")
@settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(orders | steerings | values | st.binary(max_size=40))
def test_no_document_of_a_commander_ends_the_service(live, content):
    if not live.clients:
        live.client("commander")
    commander = live.clients[0]
    document = content if isinstance(content, bytes) else json.dumps(content).encode()
    for kind in (Lead, Walk, Steer):
        number, now_s = commander.next()
        motion = number if kind is not Steer else number - 1
        message = Lead(number, now_s, motion, 0) if kind is Lead else kind(number, now_s, motion)
        commander.raw(write_control_message(message) + b"\n" + document, FrameKind.DOCUMENT)
        live.run(0.004)

    live.loop.stop(1, "the end of an example")
    live.run(0.03)
    commander.say(GetStatus())
    live.run(0.006)

    assert not commander.connection.closed
    assert commander.of("status")
    commander.heard.clear()
