"""Dialogues with a fake robot that is served in a thread: real words, desk, trees and sockets, no physics."""

import os
import threading
import time

import pytest
from py_trees.blackboard import Blackboard

from executive.chat.plain_chat import PlainChat
from executive.chat.robot_watch import RobotWatch
from executive.chat.talk import Talk
from executive.dialogue.settle_words import settled
from executive.doors.served_robot import ServedRobot
from executive.front.front_talk import FrontTalk
from executive.live.served_executive.desk import Desk, question_json, statements_of
from executive.live.served_executive.live_attendant import LiveAttendant
from executive.live.served_executive.live_executive import _is_stop, _LineStream
from executive.live.told_as_json import scene_json, tree_json
from executive.runs.run_account import RunAccount, RunSubject
from executive.runs.run_log import RunLog
from executive.screens.display import PlainDisplay
from executive.scripts.script_run import run_statements, settle_all, verdict
from executive.trust import USUAL_TRUST
from executive.understanding.conversation import Conversation
from robots.live.wire.messages import read_object, write_message
from robots.live.wire.runtime_folder import RuntimeFolder
from robots.live.wire.socket_server import SocketServer
from trees.failures import Failure
from trees.readings.odometry import what_is_around

PATIENCE_S = 60.0
HOW = "A person resets it."


class ServedFake:
    """The fake robot behind a real desk; a tick of it lasts ``tick_s`` of the wall's time.

    Attributes:
        stops: Emergency stops that came to the control socket.
    """

    def __init__(self, stage, folder, record, tick_s=0.0005, front=None):
        self.stage, self.record, self.tick_s, self._front = stage, record, tick_s, front
        self.stops, self._tree, self._last_tree = [], None, None
        self._order = self._display = self._account = None
        folder.make()
        self._desk = Desk(folder.executive_socket, self, _is_stop)
        self._control = SocketServer(folder.control_socket, self._hear)
        session = stage.session
        session._on_tick = self._show
        session.watch_periods(self._period)
        session.events.listen(self._note)
        self._periods, self._over = 0, threading.Event()
        self._conversation = Conversation()
        self._thread = threading.Thread(target=self._serve, daemon=True)
        self._thread.start()

    def close(self):
        self._over.set()
        self._thread.join()

    # what the desk and the control socket ask

    def cancel(self, reason):
        self.stage.session.cancel(reason)

    def pause(self, reason):
        self.stage.session.pause(reason)

    def resume(self):
        self.stage.session.resume()

    def hear_velocity(self, linear_m_s, angular_rad_s):
        raise AssertionError("nobody sends velocities")

    def status(self):
        question = self._desk.question
        return {
            "task": None, "t_s": self.stage.session.now_s, "paused": self.stage.session.paused,
            "state": self.stage.session._supervisor.lifecycle.state.value,
            "question": question and question_json(question),
            "tree": self._tree and tree_json(self._tree.snapshot(0.0).root), "last_tree": self._last_tree,
        }  # fmt: skip

    def scene(self):
        return scene_json(what_is_around(self.stage.session.toolbox))

    def _hear(self, caller, frame):
        message = read_object(frame.payload)
        if message["type"] == "stop":
            self.stops.append(message["reason"])
            self.stage.session.emergency_stop(message["reason"], int(message["category"]))
        engaged = {"engaged": self.stops[-1]} if self.stops else None
        about = {"robot": "talos", "scene": "two cups", "seed": 7, "emergency": engaged}
        caller.send(write_message("status", commander=os.getpid(), **about))

    # what goes on

    def _serve(self):
        while not self._over.is_set():
            self._poll()
            if (order := self._desk.next_order()) is not None:
                self._carry_out(order)
                self._desk.finish()
            time.sleep(0.002)
        self._desk.close()
        self._control.close()

    def _poll(self):
        self._desk.poll()
        self._control.poll()

    def _period(self):
        self._periods += 1
        if self._periods % 10 == 0:
            self._poll()
            time.sleep(self.tick_s)
            if self._over.is_set():
                raise SystemExit

    def _carry_out(self, order):
        session = self.stage.session
        attendant = LiveAttendant(self._desk, self._pass, lambda: session.interrupted)
        self._display = PlainDisplay(_LineStream(order))
        subject = RunSubject(order.said.text, "talos", "two cups", 7)

        def waiting():
            self._pass(0.02)
            return session.interrupted

        talk = None
        if self._front is not None:
            talk = FrontTalk(self._front, attendant.answer, self._note, waiting)
            talk.meet(session)

        def settle(understood):
            if talk is not None and talk.takes(understood):
                proposed = talk.settled(understood)
                if isinstance(proposed, Failure) or proposed.parsed.question is not None:
                    return proposed
                understood = proposed
            return settled(
                understood, attendant, "ask", self._note, lambda: session.now_s, session.interruption
            )

        with RunLog(self.record, subject.header()) as log:
            self._account = account = RunAccount(subject, log, self._display.event)
            with session.request() as request:
                arriving = statements_of(order.said, self._conversation, USUAL_TRUST)
                statements, results = settle_all(
                    arriving,
                    settle,
                    self._note,
                    lambda: session.now_s,
                    lambda: request.taken(0.0, self._note),
                )
                again = None if talk is None else talk.again
                results = results or run_statements(statements, session, attendant, "ask", self._note, again)
            ending = verdict([one for one, _ in results], results)
            account.close(ending, results, 0)
        self._last_tree = (self._tree and tree_json(self._tree.snapshot(0.0).root)) or self._last_tree
        self._tree = None
        order.end(*ending, run=str(log.path))

    def _pass(self, seconds):
        self.stage.session.hold(seconds)
        time.sleep(0.001)

    def _note(self, event):
        if self._account is not None:
            self._account.hear(event)

    def _show(self, tree):
        self._tree = tree
        self._display.tick(tree)


class Dialogue:
    """A conversation in lines, with somebody who types them when a test says so."""

    def __init__(self, robot, typed=False, reset=None):
        read_from, self._write_to = os.pipe()
        self.lines, self.log = [], []
        self.watch = RobotWatch(robot)
        self._stdin = os.fdopen(read_from, encoding="utf-8")
        self.chat = PlainChat(self._stdin, self.lines.append, typed)
        self.talk = Talk(robot, self.chat.show, self.log.append, lambda: self.watch.now, HOW, reset)
        self.keys = []
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def _run(self):
        self.chat.run(self.talk, lambda: [self.keys.pop(0)() for _ in list(self.keys)])

    def say(self, *lines):
        os.write(self._write_to, "".join(f"{line}\n" for line in lines).encode())
        return self

    def until(self, part, count=1):
        """Wait for a line of the conversation."""
        return self._wait(lambda: sum(part in line for line in self.lines) >= count, part)

    def until_it_moves(self, part="stream"):
        """Wait for a step of the tree."""
        return self._wait(lambda: any(f"EXECUTING: {part}" in line for line in self.log), part)

    def press(self, key):
        self.keys.append(key)
        return self

    def end(self):
        """End the input, and wait for the end of it all; the exit code."""
        self.close_input()
        self._thread.join(PATIENCE_S)
        assert not self._thread.is_alive(), self.lines
        self.watch.close()
        return self.talk.code

    def close_input(self):
        if self._write_to is not None:
            os.close(self._write_to)
            self._write_to = None

    @property
    def text(self):
        return "\n".join(self.lines)

    def _wait(self, condition, what):
        for _ in range(round(PATIENCE_S / 0.005)):
            if condition():
                return self
            time.sleep(0.005)
        raise AssertionError(f"in vain: {what}; {self.text}\n" + "\n".join(self.log))


@pytest.fixture
def serve(fake_stage, tmp_path):
    """Serve a fake robot before a table with things; without any there are a red and a blue cup."""
    made = []

    def serve(*things, **more):
        folder = RuntimeFolder(tmp_path / "live")
        stage = fake_stage(*things, guarded=True)
        made.append(ServedFake(stage, folder, tmp_path / "runs", **more))
        robot = ServedRobot(folder.path)
        robot.fake = made[-1]
        return robot

    yield serve
    for one in made:
        one.close()
    Blackboard.clear()


@pytest.fixture
def talk_to():
    """Begin a dialogue with a robot."""
    made = []

    def begin(robot, **more):
        made.append(Dialogue(robot, **more))
        return made[-1]

    yield begin
    for one in made:
        one.press(lambda one=one: one.talk.end("the test has ended"))
        one.close_input()
        one._thread.join(10.0)
        one.watch.close()
        one._stdin.close()
