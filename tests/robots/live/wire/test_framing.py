"""Whatever bytes arrive: frames, or an error; and no memory for what is too long."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from robots.live.wire.errors import ProtocolError
from robots.live.wire.framing import MAX_BYTES, Frame, FrameDecoder, FrameKind, encode_frame

payloads = st.binary(max_size=200)


@given(st.lists(st.tuples(st.sampled_from(FrameKind), payloads), max_size=5), st.integers(1, 40))
def test_frames_come_back_whole_however_the_stream_is_cut(sent, piece):
    stream = b"".join(encode_frame(kind, payload) for kind, payload in sent)
    decoder, found = FrameDecoder(documents=True), []

    for start in range(0, len(stream), piece):
        decoder.feed(stream[start : start + piece])
        while (frame := decoder.next()) is not None:
            found.append(frame)

    assert found == [Frame(kind, payload) for kind, payload in sent]


@pytest.mark.requirement("F4")
@given(st.binary(max_size=400))
def test_any_bytes_are_frames_or_an_error(data):
    decoder = FrameDecoder()
    decoder.feed(data)

    try:
        while decoder.next() is not None:
            pass
    except ProtocolError:
        pass


@pytest.mark.parametrize(
    ("head", "word"),
    [
        (b"GET / HTTP/1.1", "begins"),
        (b"HX\x02\x00\x00\x00\x00\x01", "version 2"),
        (b"HX\x01\x09\x00\x00\x00\x01", "kind"),
        (b"HX\x01\x00\xff\xff\xff\xff", "at most"),
        (b"HX\x01\x01\x00\x00\x00\x01", "commander"),
    ],
)
def test_a_head_that_is_wrong_is_refused_before_anything_is_stored(head, word):
    decoder = FrameDecoder()
    decoder.feed(head)

    with pytest.raises(ProtocolError, match=word):
        decoder.next()


def test_a_payload_that_is_too_long_is_not_sent_either():
    with pytest.raises(ProtocolError):
        encode_frame(FrameKind.MESSAGE, b"x" * (MAX_BYTES[FrameKind.MESSAGE] + 1))
