"""One attachment: orders are carried out, and their reports tell what became of each."""

import json

import pytest

from executive.live import live_attendant
from executive.live.desk import Order, Say, Script, ScriptLine
from executive.live.live_executive import LiveExecutive
from executive.live.planning_service import Planned
from kinematics.requests import CheckRequest
from kinematics.scene import PlanningScene
from robots.control.events import SetpointRefused, StopStarted
from robots.live.messages import read_object
from tests.executive.live.conftest import Worker, go_on_while_waited_for
from tests.robots.live.conftest import swing
from trees.world_model import WorldModel

REFUSED = SetpointRefused(0.0, "pick", "velocity", "arm_left_2_joint", 3.0, 2.0)


class Somebody:
    """The other end of an order."""

    def __init__(self):
        self.told = []

    def send(self, message):
        self.told.append(read_object(message))


class Serving:
    """An executive that is attached, and the reports of what it was told to do."""

    def __init__(self, far, folder):
        self.far, self.record = far, folder
        self.worker = Worker()
        self.live = LiveExecutive(far.folder, far.model, self.worker, WorldModel(), folder)

    def check(self, trajectory):
        """Have both sides let a trajectory pass."""
        job = self.live._planning.submit(CheckRequest(trajectory.trajectory, PlanningScene()))
        self.worker.answer(Planned(trajectory, 0.1, "{}"))
        while not job.done:
            self.live._session.hold(0.02)
        assert job.result() is trajectory

    def carry_out(self, said):
        before = set(self.record.glob("*/report.json"))
        self.live._carry_out(Order(Say(said) if isinstance(said, str) else said, Somebody()))
        (report,) = set(self.record.glob("*/report.json")) - before
        return json.loads(report.read_text())


@pytest.fixture
def serving(far, monkeypatch, tmp_path):
    go_on_while_waited_for(far, monkeypatch)
    made = Serving(far, tmp_path)
    yield made
    made.live.close()


def test_the_report_counts_what_the_gate_refused_and_what_was_stopped(serving):
    serving.far.server.note(REFUSED)
    serving.far.server.note(StopStarted(0.0, 1, "by the test"))

    safety = serving.carry_out("wait for 0.2 seconds")["safety"]

    assert safety == {"checked_trajectories": 0, "refused_setpoints": 1, "stops": ["by the test"]}


def test_the_next_report_counts_from_the_beginning(serving):
    serving.far.server.note(REFUSED)
    serving.carry_out("wait for 0.2 seconds")

    safety = serving.carry_out("wait for 0.2 seconds")["safety"]

    assert (safety["refused_setpoints"], safety["stops"]) == (0, [])


def test_what_was_checked_for_the_order_before_is_not_counted_again(serving, talos):
    serving.check(swing(talos, talos.q_home))

    assert serving.carry_out("wait for 0.2 seconds")["safety"]["checked_trajectories"] == 0


def test_an_order_that_cannot_be_recorded_is_refused_and_the_next_one_is_carried_out(serving):
    writable, serving.live._record = serving.record, serving.record / "a file" / "runs"
    serving.live._record.parent.write_text("")
    somebody = Somebody()

    serving.live._carry_out(Order(Say("wait for 0.2 seconds"), somebody))

    assert somebody.told[-1]["exit_code"] == 2
    assert "cannot write" in somebody.told[-1]["text"]
    serving.live._record = writable
    assert serving.carry_out("wait for 0.2 seconds")["outcome"] == "done"


def script(*lines):
    return Script(tuple(ScriptLine("tidy.toml", text, **more) for text, more in lines))


WAIT = ("wait for 0.2 seconds", {})


@pytest.mark.requirement("U1")
def test_a_script_that_is_sent_is_told_as_one_that_is_run(serving):
    report = serving.carry_out(script(WAIT, ("dance", {"expect": "refused"}), WAIT))

    assert (report["input"], report["exit_code"]) == ("tidy.toml", 0)
    assert report["message"].startswith("script done: 3 statements as expected; last done: ")


@pytest.mark.parametrize(("spoiled", "code"), [("pick up the zorbl", 2), ("pick up something", 3)])
def test_a_script_with_a_later_statement_that_is_not_understood_does_not_begin(
    serving, monkeypatch, spoiled, code
):
    monkeypatch.setattr(live_attendant, "ANSWER_WITHIN_S", 0.1)

    report = serving.carry_out(script(WAIT, (spoiled, {"expect": "done"})))

    assert report["exit_code"] == code
    assert [task["text"] for task in report["tasks"]] == [spoiled]


def test_a_statement_that_expects_a_question_is_not_asked(serving, monkeypatch):
    monkeypatch.setattr(live_attendant.LiveAttendant, "answer", None)

    report = serving.carry_out(script(WAIT, ("pick up something", {"expect": "question"})))

    assert (report["exit_code"], report["tasks"][-1]["outcome"]) == (0, "question")
