"""Nobody waits for an executive that hangs, and another one takes its place."""

import os

import pytest

from executive.live.caller.caller import Caller
from executive.live.caller.hang_watch import HangWatch, HungError, commander_of, hear_out
from robots.live.wire.connection import Connection
from robots.live.wire.messages import write_message
from robots.live.wire.runtime_folder import RuntimeFolder
from robots.live.wire.unix_socket import listen_at

LOOK_S = 0.01


@pytest.fixture
def knocked(tmp_path):
    """Somebody who listens, and a caller who has knocked."""
    listening = listen_at(tmp_path / "socket")
    caller = Caller(tmp_path / "socket")
    yield listening, caller
    caller.close()
    listening.close()


@pytest.mark.requirement("S9", "F8")
def test_who_speaks_to_an_executive_that_was_let_go_hears_that_it_hangs(knocked):
    with pytest.raises(HungError, match="hangs"):
        hear_out(knocked[1], lambda _: True, lambda: None, LOOK_S)


def test_a_silent_executive_that_commands_is_waited_for(knocked):
    listening, caller = knocked
    taken, looks, answering = [], [], []

    def commander():
        looks.append(1)
        if len(looks) == 1:
            return None  # let go for a moment
        if len(looks) == 5:
            answering.append(Connection(listening.accept()[0]))
            answering[0].send(write_message("result", text="done"))
        return os.getpid()

    hear_out(caller, lambda answer: taken.append(answer) or True, commander, LOOK_S)

    answering[0].close("told")
    assert [answer["text"] for answer in taken] == ["done"]
    assert len(looks) == 5


def test_where_nobody_serves_nobody_commands(tmp_path):
    assert commander_of(RuntimeFolder(tmp_path)) is None


def test_an_executive_hangs_when_it_has_lost_the_command_for_good():
    watch = HangWatch(5.0)

    assert not watch.is_hung(None, 7, 0.0)
    assert not watch.is_hung(None, 7, 100.0)  # it still loads
    assert not watch.is_hung(7, 7, 101.0)
    assert not watch.is_hung(None, 7, 105.0)
    assert not watch.is_hung(7, 7, 105.9)  # it had hung, and woke up
    assert not watch.is_hung(None, 7, 110.0)
    assert watch.is_hung(None, 7, 111.0)
    watch.forget()
    assert not watch.is_hung(None, 8, 120.0)
