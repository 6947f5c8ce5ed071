"""``executive chat`` on a real terminal, attached to the fake robot: what is drawn, and what keys do."""

import fcntl
import os
import pty
import select
import struct
import subprocess
import sys
import termios
import time

import pytest

from robots.fake.fake_world import cup

RED = cup("a", "red", (0.45, 0.2))
TASK = "wait for 120 seconds"
BEGUN = "I understood: wait"
PATIENCE_S = 60.0


class Terminal:
    """A terminal with the chat in it."""

    def __init__(self, folder, state, *options, **environment):
        self._near, far = pty.openpty()
        fcntl.ioctl(far, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 80, 0, 0))
        self.before = termios.tcgetattr(far)
        told = {**os.environ, "TERM": "xterm-256color", "XDG_STATE_HOME": str(state), **environment}
        command = [sys.executable, "-m", "executive", "chat", "--folder", str(folder), *options]
        self.process = subprocess.Popen(
            command, stdin=far, stdout=far, stderr=far, env=told, start_new_session=True,
            preexec_fn=lambda: fcntl.ioctl(0, termios.TIOCSCTTY, 0),
        )  # fmt: skip
        self._far, self.shown = far, ""

    def type(self, text):
        os.write(self._near, text.encode())
        return self

    def until(self, part):
        return self._wait(lambda: part in self.shown, part)

    def end(self):
        self._wait(lambda: self.process.poll() is not None, "the end")
        return self.process.returncode

    def settings(self):
        return termios.tcgetattr(self._far)

    def close(self):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        os.close(self._near)
        os.close(self._far)

    def _wait(self, condition, what):
        until_s = time.monotonic() + PATIENCE_S
        while time.monotonic() < until_s:
            if condition():
                return self
            ready, _, _ = select.select([self._near], [], [], 0.05)
            if ready:
                self.shown += os.read(self._near, 65536).decode("utf-8", "replace")
        raise AssertionError(f"in vain: {what}; {self.shown[-3000:]!r}")


@pytest.fixture
def terminal(tmp_path, signals_heard):
    made = []

    def begin(robot, *options, **environment):
        made.append(Terminal(robot._where.path, tmp_path / "state", *options, **environment))
        return made[-1]

    yield begin
    for one in made:
        one.close()


@pytest.mark.requirement("U1")
def test_a_conversation_on_a_screen_leaves_the_terminal_as_it_was_and_its_words_below(serve, terminal):
    chat = terminal(serve()).until("Ctrl-X stop").type("pick up the cup\r").until("which cup?")
    chat.type("2\r").until("Done: blue cup held").type("\x04")

    assert chat.end() == 0
    assert chat.settings() == chat.before
    said = chat.shown.rpartition("\x1b[?1049l")[2]
    assert "you    pick up the cup" in said
    assert "robot  Done: blue cup held" in said


@pytest.mark.requirement("S4")
def test_the_stop_key_stops_while_a_task_runs_and_a_typed_reset_is_said_to_be_possible(serve, terminal):
    robot = serve(RED, tick_s=0.005)
    chat = terminal(robot).until("Ctrl-X stop").type(f"{TASK}\r").until(BEGUN).type("\x18")
    chat.until("EMERGENCY").until("'reset' here").until("Cancelled").type("\x04")

    assert chat.end() == 4
    assert robot.fake.stops == ["the stop key of the chat"]


@pytest.mark.requirement("S7")
def test_ctrl_c_clears_the_line_cancels_a_task_and_leaves_a_free_robot(serve, terminal):
    chat = terminal(serve(RED, tick_s=0.005)).until("Ctrl-X stop").type(f"{TASK}\r").until(BEGUN)
    chat.type("\x03").until("Cancelled: ").type("wave").until("wave")
    chat.shown = ""
    chat.type("\x03").until("you › \x1b[0m\x1b[7m \x1b[0m").type("\x03")

    assert chat.end() == 4


@pytest.mark.requirement("U1")
def test_lines_typed_in_the_chat_before_come_back_by_the_arrow_key(serve, terminal):
    robot = serve(RED)
    chat = terminal(robot).until("Ctrl-X stop").type("wait for 0.1 seconds\r").until("Done").type("\x04")
    chat.end()
    again = terminal(robot).until("Ctrl-X stop").type("\x1b[A\r").until("Done").type("\x04")

    assert again.end() == 0
    assert "you    wait for 0.1 seconds" in again.shown


@pytest.mark.requirement("U1")
def test_without_colour_nothing_is_coloured(serve, terminal):
    chat = terminal(serve(RED), NO_COLOR="1").until("Ctrl-X stop").type("help\r").until("Say what to do")
    chat.type("\x04").end()

    assert "\x1b[32m" not in chat.shown
    assert "\x1b[1;36m" not in chat.shown


@pytest.mark.requirement("U1")
def test_plain_lines_on_a_terminal_hear_a_stop_while_a_task_runs(serve, terminal):
    robot = serve(RED, tick_s=0.005)
    chat = terminal(robot, "--plain").until("Say what to do").type(f"{TASK}\n").until(BEGUN)
    chat.type("stop\n").until("Stopped: ").until("Cancelled: ").type("\x04")

    assert chat.end() == 4
    assert len(robot.fake.stops) == 1


@pytest.mark.requirement("U1")
def test_a_terminal_that_goes_cancels_what_is_under_way(serve, terminal):
    robot = serve(RED, tick_s=0.005)
    chat = terminal(robot).until("Ctrl-X stop").type(f"{TASK}\r").until(BEGUN)
    chat.process.send_signal(1)

    assert chat.end() == 4
