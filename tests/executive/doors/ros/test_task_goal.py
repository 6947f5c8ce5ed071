"""A goal of an action, carried out over a real desk; who attends to the desk is played here."""

import sys
import threading
from pathlib import Path

import pytest

import executive.doors.ros.node
from executive.dialogue.clarification import OpenQuestion
from executive.exit_codes import ExitCode
from executive.live.desk_messages import FollowTrajectory, Say
from executive.live.served_executive.desk import Desk
from robots.clock import WallClock

NODE = Path(executive.doors.ros.node.__file__).parent
TREE = [
    {"depth": 0, "name": "pick", "status": "running", "message": ""},
    {"depth": 1, "name": "reach", "status": "running", "message": "0.4 m"},
]
WHICH = OpenQuestion("which cup?", ("red", "blue"))


class Attendant:
    """Polls a desk in a thread, and does with each order what it was told to, a little at each poll."""

    def __init__(self, path, doing):
        self.desk, self.orders, self.reasons = Desk(path, self, lambda _text: False), [], []
        self._doing, self._over = doing, threading.Event()
        self._thread = threading.Thread(target=self._run)
        self._thread.start()

    def cancel(self, reason):
        self.reasons.append(reason)

    def status(self):
        question = self.desk.question
        told = question and {"text": question.text, "choices": list(question.choices)}
        return {"paused": False, "tree": TREE if self.desk.current else None, "question": told}

    def close(self):
        self._over.set()
        self._thread.join()
        self.desk.close()

    def _run(self):
        clock = WallClock()
        while not self._over.is_set():
            self.desk.poll()
            order = self.desk.current or self.desk.next_order()
            if order is not None:
                if not self.orders:
                    self.orders.append(order.said)
                if self._doing(self, order):
                    self.desk.finish()
            clock.sleep(0.002)


@pytest.fixture
def task_goal(monkeypatch):
    monkeypatch.syspath_prepend(str(NODE))
    for name in ("task_goal", "robot_link", "progress"):
        monkeypatch.delitem(sys.modules, name, raising=False)
    import task_goal

    monkeypatch.setattr(task_goal, "LOOKS_EVERY_S", 0.0)
    return task_goal


@pytest.fixture
def attended(tmp_path_factory):
    made = []

    def attend(doing):
        folder = tmp_path_factory.mktemp("live")
        made.append(Attendant(folder / "executive.sock", doing))
        return folder, made[-1]

    yield attend
    for one in made:
        one.close()


def test_lines_tree_and_question_are_told_until_the_end(task_goal, attended):
    def doing(robot, order):
        if robot.desk.question is None and not robot.desk.given:
            order.tell("accepted")
            robot.desk.question = WHICH
        if robot.desk.given:
            order.end("done: picked", "done", ExitCode.DONE, run="/runs/1")
        return bool(robot.desk.given)

    folder, robot = attended(doing)
    told = []

    def tell(progress):
        told.append(progress)
        if progress.question and not robot.desk.given:
            robot.desk.given.append("the red one")

    ending = task_goal.carry_out(folder, {"kind": "say", "text": "pick up a cup"}, tell, lambda: "")

    assert robot.orders == [Say("pick up a cup")]
    assert (ending["outcome"], ending["run"]) == ("done", "/runs/1")
    assert told[0].line == "accepted"
    assert told[-1].tree_path == ("pick", "reach")
    assert told[-1].quantities == [(0.4, "m")]
    assert (told[-1].question, told[-1].choices) == ("which cup?", ("red", "blue"))


@pytest.mark.requirement("S7")
def test_what_has_to_end_is_cancelled_once_and_heard_out(task_goal, attended):
    def doing(robot, order):
        if robot.reasons:
            order.end("cancelled: halted", "cancelled", ExitCode.CANCELLED)
        return bool(robot.reasons)

    folder, robot = attended(doing)

    ending = task_goal.carry_out(
        folder,
        {"kind": "follow_trajectory", "path": "/motion.json"},
        lambda _: None,
        lambda: "the client is gone",
    )

    assert robot.orders == [FollowTrajectory("/motion.json")]
    assert robot.reasons == ["the client is gone"]
    assert ending["outcome"] == "cancelled"


def test_where_no_robot_is_served_the_goal_fails(task_goal, tmp_path):
    ending = task_goal.carry_out(tmp_path, {"kind": "say", "text": "wave"}, lambda _: None, lambda: "")

    assert (ending["outcome"], ending["exit_code"]) == ("failed", 1)


def test_what_the_desk_does_not_take_is_a_refusal(task_goal, attended):
    folder, _ = attended(lambda *_: False)

    ending = task_goal.carry_out(folder, {"kind": "say", "text": 5}, lambda _: None, lambda: "")

    assert (ending["outcome"], ending["exit_code"]) == ("refused", 2)
