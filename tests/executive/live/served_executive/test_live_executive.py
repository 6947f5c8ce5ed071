"""One attachment: orders are carried out, and their reports tell what became of each."""

import gc
import json
import weakref
from concurrent.futures import Future
from types import SimpleNamespace

import pytest

from executive.live.control_client.control_link import ControlLostError
from executive.live.control_client.planning_service import Planned, PlanningService
from executive.live.desk_messages import FollowTrajectory, Say, Script, ScriptLine
from executive.live.served_executive import live_attendant
from executive.live.served_executive.desk import Order
from executive.live.served_executive.live_executive import LiveExecutive
from executive.trust import Trust
from kinematics.requests.check import CheckRequest
from kinematics.scene.planning_scene import PlanningScene
from robots.control.events import SetpointRefused, StopStarted
from robots.live.process.admission_process import Admission
from robots.live.wire.messages import read_object
from tests.executive.live.conftest import Worker, go_on_while_waited_for
from tests.executive.session import test_session
from tests.robots.live.conftest import swing
from trees.failures import Failure, OpenChoice
from trees.snapshot import NodeSnapshot, TreeSnapshot
from trees.world_model import WorldModel

REFUSED = SetpointRefused(0.0, "pick", "velocity", "arm_left_2_joint", 3.0, 2.0)


class Tree(test_session.Tree):
    """Ends after some ticks, and has one node to show."""

    leaf_places = frozenset()

    def snapshot(self, t_s):
        return TreeSnapshot(t_s, 0, NodeSnapshot("task", "sequence", "running", ""))


class Somebody:
    """The other end of an order, who may do something when a question comes."""

    def __init__(self, when_asked=lambda: None):
        self.told, self.when_asked = [], when_asked

    def send(self, message):
        self.told.append(read_object(message))
        if "executive answer" in str(self.told[-1].get("text")):
            self.when_asked()


class Serving:
    """An executive that is attached, and the reports of what it was told to do."""

    def __init__(self, far, folder):
        self.far, self.record = far, folder
        self.worker = Worker()
        self.live = LiveExecutive(far.folder, far.model, self.worker, WorldModel(), folder)

    def check(self, trajectory):
        """Have both sides let a trajectory pass."""
        job = self.live._planning.check(CheckRequest(trajectory.trajectory, PlanningScene()))
        self.worker.answer(Planned(trajectory, 0.1, "{}"))
        while not job.done:
            self.live._session.hold(0.02)
        assert job.result() is trajectory

    def carry_out(self, said, somebody=None):
        before = set(self.record.glob("*/report.json"))
        order = Order(Say(said) if isinstance(said, str) else said, somebody or Somebody())
        self.live._desk.current = order
        try:
            self.live._carry_out(order)
        finally:
            self.live._desk.finish()
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


@pytest.fixture
def asking(serving):
    """Each task asks which of two cups."""
    which = Failure.asking("which cup?", OpenChoice(("red cup", "blue cup"), ("red cup", "blue cup")))
    serving.live._session._build = lambda _task, _toolbox: Tree(1, which)
    return serving


GO_ON = {"on_failure": "continue"}


@pytest.mark.requirement("S7")
def test_a_cancel_while_a_task_asks_ends_a_script_that_goes_on_after_failures(asking):
    somebody = Somebody(lambda: asking.live.cancel("enough"))

    report = asking.carry_out(script(("go home", GO_ON), ("wait for 0.2 seconds", GO_ON)), somebody)

    assert report["exit_code"] == 4
    assert [(task["text"], task["outcome"]) for task in report["tasks"]] == [("go home", "cancelled")]


@pytest.mark.requirement("S7")
def test_a_cancel_while_the_words_are_asked_about_ends_a_script_that_goes_on_after_failures(serving):
    somebody = Somebody(lambda: serving.live.cancel("enough"))

    report = serving.carry_out(script(("pick up something", GO_ON), WAIT), somebody)

    assert report["exit_code"] == 4
    assert [task["outcome"] for task in report["tasks"]] == ["cancelled"]


@pytest.mark.requirement("S7")
def test_a_cancel_of_one_order_does_not_reach_the_next(asking):
    asking.carry_out("go home", Somebody(lambda: asking.live.cancel("enough")))
    asking.live._session._build = None

    assert asking.carry_out("wait for 0.2 seconds")["outcome"] == "done"


@pytest.mark.requirement("S4")
@pytest.mark.parametrize("text", ["go home", "pick up something"])
def test_an_emergency_stop_ends_a_question_that_waits(asking, text):
    def stop():
        asking.far.loop.emergency_stop("the red button", 1)

    began_s = asking.far.clock.now_s()
    report = asking.carry_out(script((text, GO_ON), WAIT), Somebody(stop))

    assert report["exit_code"] == 4
    assert "the red button" in report["message"]
    assert asking.far.clock.now_s() - began_s < live_attendant.ANSWER_WITHIN_S / 2


@pytest.mark.requirement("S7")
def test_what_is_paused_while_it_asks_is_held_after_the_answer(asking):
    session, desk, held = asking.live._session, asking.live._desk, []
    session._pause._pausing = SimpleNamespace(pause=held.append, resume=lambda: held.append("it goes on"))
    ticks = iter(range(30))
    session.watch_periods(lambda: desk.question and not desk.given and desk.given.append("red cup"))
    session.watch_periods(lambda: held and next(ticks, None) is None and session.resume())

    def pause():
        asking.live.pause("a moment")
        session._build = lambda _task, _toolbox: Tree(3)

    report = asking.carry_out("pick up the cup", Somebody(pause))

    assert (held, report["outcome"]) == (["a moment", "it goes on"], "done")


@pytest.mark.requirement("S9")
def test_a_report_of_a_live_run_tells_what_was_left_out(serving):
    serving.live._trust = Trust(0.8, "partial")
    steps = [
        {"command": "wait for 0.2 seconds", "confidence": 0.95},
        {"command": "go home", "confidence": 0.5},
    ]

    report = serving.carry_out(json.dumps(steps))

    assert [step["text"] for step in report["left_out"]] == ["go home"]


@pytest.mark.requirement("S3")
def test_a_lost_control_process_is_told_to_who_gave_the_order(serving):
    def lose(_tree):
        serving.live._link._connection.close("gone")

    serving.live._session._on_tick = lose
    somebody = Somebody()

    with pytest.raises(ControlLostError):
        serving.carry_out("wait for 5 seconds", somebody)

    assert (somebody.told[-1]["type"], somebody.told[-1]["exit_code"]) == ("result", 1)
    assert "the control process ended" in somebody.told[-1]["text"]
    (report,) = serving.record.glob("*/report.json")
    assert json.loads(report.read_text())["outcome"] == "failed"


class AnsweredHere:
    """A process that answers, only that it is this one."""

    def __init__(self, answer):
        self.answer = answer

    def ask(self, question):
        future = Future()
        future.set_result(self.answer(question))
        return future


@pytest.fixture
def judging(serving):
    """Both sides have a checker."""
    serving.live._planning._worker = AnsweredHere(PlanningService("talos").answer)
    serving.far.checker.ask = AnsweredHere(Admission("talos").judge).ask
    return serving


def handed_in(tmp_path, talos, *points, joint="arm_left_4_joint"):
    path = tmp_path / "motion.json"
    here = float(talos.q_home[7 + talos.joint_index("arm_left_4_joint")])
    told = [{"t_s": t_s, "positions": [here + away]} for t_s, away in points]
    path.write_text(json.dumps({"joints": [joint], "points": told}))
    return FollowTrajectory(str(path))


@pytest.mark.requirement("S6")
def test_a_trajectory_that_the_checker_admits_is_carried_out(judging, talos, tmp_path):
    report = judging.carry_out(handed_in(tmp_path, talos, (2.0, -0.1)))

    assert report["outcome"] == "done", report["message"]
    assert report["safety"]["checked_trajectories"] == 1
    reached = judging.far.loop.motion.reference() - talos.q_home
    assert reached[7 + talos.joint_index("arm_left_4_joint")] == pytest.approx(-0.1, abs=1e-6)


@pytest.mark.requirement("S6")
def test_a_trajectory_that_is_too_fast_is_refused_with_the_finding(judging, talos, tmp_path):
    report = judging.carry_out(handed_in(tmp_path, talos, (0.01, -0.5)))

    assert (report["outcome"], report["exit_code"]) == ("failed", 5)
    assert report["tasks"][0]["failure"]["kind"] == "UNSAFE"
    assert "arm_left_4_joint" in report["message"]
    assert judging.far.loop.motion.reference() == pytest.approx(talos.q_home)


@pytest.mark.parametrize("joint", ["arm_left_9_joint", ""])
def test_a_trajectory_of_no_such_joint_moves_nothing(judging, talos, tmp_path, joint):
    report = judging.carry_out(handed_in(tmp_path, talos, (2.0, -0.1), joint=joint))

    assert report["outcome"] in ("failed", "refused")
    assert report["safety"]["checked_trajectories"] == 0


def test_a_trajectory_that_cannot_be_read_is_refused_with_its_file(judging, tmp_path):
    report = judging.carry_out(FollowTrajectory(str(tmp_path / "nothing.json")))

    assert (report["outcome"], report["exit_code"]) == ("refused", 2)
    assert "nothing.json: is no file" in report["message"]


def test_what_refers_to_itself_is_gone_when_an_order_is_over(serving):
    class Knot:
        pass

    knot = Knot()
    knot.itself = knot
    tied = weakref.ref(knot)
    gc.disable()
    try:
        del knot
        serving.carry_out("wait for 0.2 seconds")
        assert tied() is None
    finally:
        gc.enable()
