"""Keys at a terminal: cancel, emergency stop, pause, and answers."""

import os
import pty
import termios

import pytest

from executive.dialogue.clarification import OpenQuestion
from executive.manual.keys import JogKeys
from executive.manual.words import JogFeed
from executive.screens.keyboard import Keyboard
from executive.screens.keyboard_attendant import KeyboardAttendant
from trees.failures import Failure

QUESTION = OpenQuestion("which cup?", ("red cup", "blue cup"))


class Typed:
    """Keys and a line that somebody typed before."""

    def __init__(self, keys, line=None):
        self._waiting, self.typed = list(keys), line

    def key(self, timeout_s=0.0):
        return self._waiting.pop(0) if self._waiting else ""

    def line(self, timeout_s, interrupted=lambda: False):
        return None if interrupted() else self.typed


class Screen:
    def __init__(self):
        self.told = []

    def ask(self, question):
        self.told.append(("ask", question))

    def pause(self, paused):
        self.told.append(("pause", paused))

    def close(self):
        self.told.append(("close", None))


class Session:
    def __init__(self):
        self.done = []

    def cancel(self, reason):
        self.done.append(("cancel", reason))

    def emergency_stop(self, reason, category=1):
        self.done.append(("stop", reason))

    def pause(self, reason):
        self.done.append(("pause", reason))

    def resume(self):
        self.done.append(("resume",))


def at(keys, line=None):
    screen, session = Screen(), Session()
    attendant = KeyboardAttendant(Typed(keys, line), screen)
    attendant.begin(session)
    return attendant, screen, session


@pytest.mark.requirement("S7")
def test_c_cancels():
    attendant, _, session = at("c")

    attendant.attend(session)

    assert session.done == [("cancel", "cancelled from the keyboard")]


@pytest.mark.requirement("S4")
@pytest.mark.parametrize("keys", ["e", "pe"])
def test_e_is_the_emergency_stop_also_while_paused(keys):
    attendant, _, session = at(keys)

    for _ in keys:
        attendant.attend(session)

    assert session.done[-1] == ("stop", "stopped from the keyboard")


def test_p_pauses_until_p_again():
    attendant, screen, session = at("pxp")

    attendant.attend(session)
    attendant.attend(session)
    assert session.done == [("pause", "paused from the keyboard")]
    attendant.attend(session)

    assert screen.told == [("pause", True), ("pause", False)]
    assert session.done[1:] == [("resume",)]


@pytest.mark.requirement("S7")
def test_c_in_a_pause_ends_it_and_cancels():
    attendant, screen, session = at("pc")

    attendant.attend(session)
    attendant.attend(session)

    assert session.done[1:] == [("resume",), ("cancel", "cancelled from the keyboard")]
    assert screen.told[-1] == ("pause", False)


def test_other_keys_and_no_key_do_nothing():
    attendant, screen, session = at("x")

    attendant.attend(session)
    attendant.attend(session)

    assert not session.done
    assert not screen.told


@pytest.mark.requirement("L6")
@pytest.mark.parametrize(
    ("keys", "line", "answer"),
    [
        ("2", None, "2"),
        ("xy1", None, "1"),
        ("a", "the blue one", "the blue one"),
        ("c", None, "never mind"),
        ("", None, None),
    ],
)
def test_a_question_is_answered_by_key_or_in_words(keys, line, answer):
    attendant, screen, _ = at(keys, line)

    assert attendant.answer(QUESTION) == answer
    assert screen.told[0] == ("ask", QUESTION)
    assert screen.told[-1] == ("ask", None)


def test_e_while_a_question_is_open_stops_and_leaves_it_open():
    attendant, _, session = at("e")

    assert attendant.answer(QUESTION) is None
    assert session.done == [("stop", "stopped from the keyboard")]


@pytest.mark.requirement("S7")
@pytest.mark.parametrize("keys", ["", "a"])
def test_nobody_is_waited_for_once_the_run_is_cancelled(keys):
    screen, looks = Screen(), iter([False, True, True])
    attendant = KeyboardAttendant(Typed(keys, "too late"), screen, 60.0, lambda: next(looks))

    assert attendant.answer(QUESTION) is None
    assert screen.told[-1] == ("ask", None)


def test_a_real_terminal_gives_single_keys_and_is_left_as_it_was():
    master, slave = pty.openpty()
    try:
        before = termios.tcgetattr(slave)
        with os.fdopen(os.dup(slave), "r") as stdin, Keyboard(stdin) as keyboard:
            os.write(master, b"c")
            assert keyboard.key(1.0) == "c"
            assert keyboard.key() == ""
            os.write(master, b"the blue one\n")
            assert keyboard.line(1.0) == "the blue one"
        assert termios.tcgetattr(slave) == before
    finally:
        os.close(master)
        os.close(slave)


def test_a_terminal_that_has_gone_gives_no_keys_and_no_lines():
    master, slave = pty.openpty()
    with os.fdopen(slave, "r") as stdin, Keyboard(stdin) as keyboard:
        os.close(master)

        assert keyboard.key() == ""
        assert keyboard.line(0.2) is None


class Hands:
    def __init__(self):
        self.feed, self.offer = JogFeed(), None


class Named(Typed):
    """Keys by name, while somebody jogs."""

    def keys(self, timeout_s=0.0):
        return (self.named.pop(0),) if self.named else ()


def jogging(keys, named=()):
    typed, screen, session = Named(keys), Screen(), Session()
    typed.__dict__["named"] = list(named)
    screen.width, screen.shown = 80, []
    screen.jog, screen.offer = screen.shown.append, screen.shown.append
    session.hands, session.now_s = Hands(), 1.0
    arms = {"right": ("one", "two"), "left": ("three",)}
    attendant = KeyboardAttendant(typed, screen, jog_keys=JogKeys(arms))
    attendant.begin(session)
    return attendant, screen, session


@pytest.mark.requirement("S10")
def test_t_takes_over():
    attendant, _, session = jogging("t")

    attendant.attend(session)

    assert session.hands.feed.asked


@pytest.mark.requirement("S10")
@pytest.mark.parametrize(("key", "taken"), [("t", True), ("x", False)])
def test_after_a_failure_t_takes_over_and_any_other_key_leaves_it_so(key, taken):
    _, screen, session = jogging(key)

    assert session.hands.offer(Failure.infeasible("out of reach")) is taken
    assert screen.shown == [True, False]


@pytest.mark.requirement("S10")
def test_a_person_who_has_the_robot_jogs_it_and_says_what_is_so_at_the_end():
    attendant, screen, session = jogging("", ["up", "enter", "1"])
    feed = session.hands.feed
    feed.active = True

    attendant.attend(session)
    said = feed.newest.word
    attendant.attend(session)
    asked = screen.shown[-1]
    attendant.attend(session)

    assert said.linear_m_s[0] > 0.0
    assert any("what is so?" in line for line in asked)
    assert feed.ending == "held_right"
    assert screen.shown[-1] == ()
