"""A node's readers."""

import time

import pytest

from executive.doors.ros.graph import RosNode, reliable, taken
from executive.doors.ros.messages import String
from executive.doors.ros.settings import RosSettings

pytestmark = pytest.mark.requirement("U3")
DOMAIN = 43


@pytest.fixture
def pair(request):
    """A reader of a topic, and a writer that it hears."""
    topic = f"/{request.node.name}"
    node = RosNode(RosSettings(DOMAIN))
    reader, writer = node.reader(topic, String, reliable()), node.writer(topic, String, reliable())
    wait(lambda: writer.get_matched_subscriptions() and reader.get_matched_publications())
    yield reader, writer
    del node  # what it holds ends with it


def wait(so):
    until = time.monotonic() + 30.0
    while not so():
        assert time.monotonic() < until
        time.sleep(0.01)


def broken():
    """A text whose bytes are no UTF-8."""
    said = String("aaaa")
    whole = said.serialize()
    said.serialize = lambda **_options: whole.replace(b"aaaa", b"aa\x99a")
    return said


def test_a_sample_that_cannot_be_read_is_passed_over_and_the_others_are_taken(pair):
    reader, writer = pair
    heard = []
    for said in (String("before"), broken(), String("after")):
        writer.write(said)

    wait(lambda: heard.extend(taken(reader)) or len(heard) == 2)

    assert [one.data for one in heard] == ["before", "after"]
