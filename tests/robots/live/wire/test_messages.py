"""There is no message that is half understood."""

import dataclasses
import json

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from robots.live.wire.errors import ProtocolError
from robots.live.wire.messages import (
    CancelMotion,
    Heartbeat,
    Start,
    Stop,
    read_control_message,
    write_control_message,
)

json_values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(), inner, max_size=4),
    max_leaves=10,
)
GOOD = Heartbeat(7, 1.25, True, False, True, 3)


@given(st.integers(0, 2**40), st.floats(0, 1e6), st.booleans(), st.booleans(), st.integers(0, 10**6))
def test_a_message_comes_back_as_it_was_sent(number, stamp_s, busy, looking, version):
    sent = Heartbeat(number, stamp_s, busy, looking, not looking, version)

    assert read_control_message(write_control_message(sent)) == sent


@pytest.mark.requirement("F4", "F8")
@settings(max_examples=40)
@given(st.one_of(st.binary(max_size=300), json_values.map(lambda v: json.dumps(v).encode())))
def test_anything_else_is_an_error_and_nothing_worse(payload):
    with pytest.raises(ProtocolError):
        read_control_message(payload)


@pytest.mark.requirement("F4")
@given(st.sampled_from([f.name for f in dataclasses.fields(Heartbeat)]), json_values)
def test_a_field_of_another_type_is_refused_or_means_the_same(field, value):
    document = json.loads(write_control_message(GOOD))
    document[field] = value

    try:
        read = read_control_message(json.dumps(document).encode())
    except ProtocolError:
        return
    assert type(getattr(read, field)) is type(getattr(GOOD, field))


@pytest.mark.parametrize(
    "payload",
    [
        b'{"type":"stop","category":3,"reason":""}',
        b'{"type":"stop","category":true,"reason":""}',
        b'{"type":"stop","reason":""}',
        b'{"type":"stop","category":1,"reason":"","force":true}',
        b'{"type":"stop","category":1,"category":0,"reason":""}',
        b'{"type":"start","number":1,"stamp_s":NaN,"motion":1,"trajectory":1}',
        b'{"type":"start","number":1e400,"stamp_s":0,"motion":1,"trajectory":1}',
        b'{"type":"hello","role":"god"}',
        b'{"type":"sudo"}',
        b"[" * 50_000,
        b'["type"]',
        b"",
    ],
)
def test_what_is_nearly_a_message_is_none(payload):
    with pytest.raises(ProtocolError):
        read_control_message(payload)


@pytest.mark.parametrize("message", [Stop(1, "why"), Start(1, 0.5, 2, 3), CancelMotion(4, 5, "x")], ids=str)
def test_every_field_is_needed(message):
    document = json.loads(write_control_message(message))
    for field in [key for key in document if key != "type"]:
        less = {key: value for key, value in document.items() if key != field}
        with pytest.raises(ProtocolError, match=field):
            read_control_message(json.dumps(less).encode())
