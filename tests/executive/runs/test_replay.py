"""A recorded run comes out the same again, whatever was done to it; what does not is told."""

import json

import pytest

from executive.config import forget_config, use_config
from executive.dialogue import attendant as attendants
from executive.runs.replay import NotReplayableError, replay
from executive.runs.run import perform
from executive.runs.run_log import recorded_run
from executive.runs.run_request import RunRequest
from executive.screens.display import NoDisplay
from executive.scripts.task_script import load_script, script_for
from robots.scenes.planned_fault import PlannedFault

TWO_CUPS = """
[[furniture]]
name = "table"
kind = "table"
size_m = [0.6, 1.2, 0.9]
position_m = [0.65, 0.0]
[[object]]
name = "a"
kind = "cup"
color = "red"
radius_m = 0.03
height_m = 0.11
mass_kg = 0.2
friction = 0.6
on = "table"
position_m = [-0.15, -0.2]
[[object]]
name = "b"
kind = "cup"
color = "blue"
radius_m = 0.03
height_m = 0.11
mass_kg = 0.2
friction = 0.6
on = "table"
position_m = [-0.15, 0.2]
"""


class Meddling(attendants.Nobody):
    """Answers, cancels, stops or pauses for half a second, at given times."""

    def __init__(self, answers=(), cancel_s=None, stop_s=None, pause_s=None, categories=(1,), when_asked=""):
        self.categories, self.when_asked, self.session = categories, when_asked, None
        self.answers, self.cancel_s, self.stop_s = list(answers), cancel_s, stop_s
        self.pauses = [] if pause_s is None else [(pause_s, "pause"), (pause_s + 0.5, "resume")]

    def begin(self, session):
        self.session = session
        session.watch_periods(lambda: self.stop(session))

    def stop(self, session):
        if self.stop_s is not None and session.now_s >= self.stop_s:
            self.stop_s = None
            for category in self.categories:
                session.emergency_stop("the red button", category)

    def answer(self, question):
        if self.when_asked:
            getattr(self.session, self.when_asked)("while it asked")
        return self.answers.pop(0) if self.answers else None

    def attend(self, session):
        if self.cancel_s is not None and session.now_s >= self.cancel_s:
            self.cancel_s = None
            session.cancel("changed my mind")
        if self.pauses and session.now_s >= self.pauses[0][0]:
            _, what = self.pauses.pop(0)
            if what == "pause":
                session.pause("the door bell")
            else:
                session.resume()


@pytest.fixture
def run(tmp_path):
    scene = tmp_path / "two_cups.toml"
    scene.write_text(TWO_CUPS)

    def record(text, faults=(), perception=None, snapshot=None, **meddling):
        script = tmp_path / "script.toml"
        if text.startswith("[["):
            script.write_text(text)
        kept = script if script.exists() else None
        statements = (script_for(text) if kept is None else load_script(script)).statements
        request = RunRequest(
            text, statements, "talos", str(scene), 3, tmp_path / "runs", script=kept, faults=tuple(faults),
            perception=perception, snapshot=snapshot,
        )  # fmt: skip
        performance = perform(request, NoDisplay(), Meddling(**meddling))
        return performance, recorded_run(tmp_path / "runs", "latest")

    return record


@pytest.mark.requirement("U1")
@pytest.mark.parametrize(
    ("text", "meddling", "outcome"),
    [
        ("pick up the cup", {"answers": ["the purple one", "never mind"]}, "cancelled"),
        ("pick up the red cup", {"cancel_s": 0.83}, "cancelled"),
        ("pick up the red cup", {"stop_s": 0.471}, "cancelled"),
        ("pick up the red cup", {"stop_s": 0.471, "categories": (0, 1)}, "cancelled"),
        ("pick up the red cup", {"pause_s": 0.7, "cancel_s": 1.5}, "cancelled"),
        ("pick up the cup", {"when_asked": "cancel"}, "cancelled"),
        ("pick up the cup", {"when_asked": "emergency_stop"}, "cancelled"),
    ],
    ids=str,
)
def test_a_run_comes_out_the_same_with_its_answers_cancels_stops_and_pauses(run, text, meddling, outcome):
    performance, recorded = run(text, **meddling)

    verdict = replay(recorded)

    assert performance.report.outcome == outcome
    assert verdict.difference is None
    assert verdict.events > 3


@pytest.mark.requirement("U1", "P2")
def test_what_the_camera_saw_is_seen_again(run):
    _, recorded = run("what is on the table?", perception="rgbd", cancel_s=2.0)

    verdict = replay(recorded)

    assert verdict.difference is None
    assert verdict.events > 3


@pytest.mark.opengl
@pytest.mark.requirement("U1")
def test_a_run_of_which_a_picture_was_taken_comes_out_the_same_without(run, tmp_path):
    _, recorded = run("pick up the red cup", snapshot=tmp_path / "end.png", cancel_s=0.8)

    assert (tmp_path / "end.png").exists()
    assert replay(recorded).difference is None


@pytest.mark.requirement("U1", "S4")
def test_every_stop_that_was_asked_for_is_recorded(run):
    _, recorded = run("pick up the red cup", stop_s=0.471, categories=(0, 1))

    events = map(json.loads, (recorded.path / "events.jsonl").read_text().splitlines())
    assert [event["value"][0] for event in events if event.get("what") == "emergency_stop"] == ["0", "1"]


@pytest.mark.requirement("U1", "F5")
def test_faults_happen_again_in_a_replay(run):
    faults = [
        PlannedFault("object_gone", 0.3, "a"),
        PlannedFault("encoder_offset", 0.5, "arm_left_4_joint", (0.05,)),
    ]
    _, recorded = run("pick up the red cup", faults, cancel_s=0.9)
    unharmed = {key: value for key, value in recorded.header.items() if key != "faults"}

    assert replay(recorded).difference is None
    assert replay(type(recorded)(recorded.path, unharmed, recorded.report)).difference is not None


@pytest.mark.parametrize("spoilt", [[{"name": "flood", "t_s": 1.0}], [{}], 7, [[1]]])
def test_a_run_whose_faults_nobody_knows_is_not_replayed(went_home, spoilt):
    recorded = type(went_home)(went_home.path, {**went_home.header, "faults": spoilt}, went_home.report)

    with pytest.raises(NotReplayableError, match="faults"):
        replay(recorded)


def test_a_script_is_replayed_from_its_copy(run, tmp_path):
    _, recorded = run('[[task]]\nsay = "go home"\n[[task]]\nsay = "fly"\nexpect = "refused"\n')
    (tmp_path / "script.toml").unlink()

    assert replay(recorded).difference is None


@pytest.fixture(scope="module")
def went_home(tmp_path_factory):
    folder = tmp_path_factory.mktemp("runs")
    perform(
        RunRequest("go home", script_for("go home").statements, "talos", "tabletop", 0, folder), NoDisplay()
    )
    return recorded_run(folder, "latest")


def test_the_first_event_that_differs_is_told(went_home):
    file = went_home.path / "events.jsonl"
    before = file.read_text().splitlines()
    file.write_text("\n".join([before[0], before[1].replace("0.2", "0.21"), *before[2:]]) + "\n")

    verdict = replay(went_home)

    file.write_text("\n".join(before) + "\n")
    assert verdict.difference.number == 2
    assert '"t_s":0.21' in verdict.difference.recorded
    assert '"t_s":0.2,' in verdict.difference.replayed


def test_a_missing_event_is_told(went_home):
    file = went_home.path / "events.jsonl"
    before = file.read_text()
    file.write_text(before + json.dumps({"event": "NodeChanged"}) + "\n")

    verdict = replay(went_home)

    file.write_text(before)
    assert verdict.difference.replayed == ""


def test_a_run_that_was_cut_off_is_compared_as_far_as_it_goes(went_home):
    file, report = went_home.path / "events.jsonl", went_home.path / "report.json"
    before = file.read_text()
    file.write_text("\n".join(before.splitlines()[:4]) + '\n{"event": "Node')
    cut = recorded_run(went_home.path.parent, "latest")

    verdict = replay(type(cut)(cut.path, cut.header, {}))

    file.write_text(before)
    assert report.is_file()
    assert verdict.difference is None
    assert verdict.cut_off
    assert list(verdict.lines()) == ["identical: 4 events as far as the recording goes"]


def test_a_live_run_is_not_replayed(went_home):
    live = type(went_home)(went_home.path, {**went_home.header, "live": True}, went_home.report)

    with pytest.raises(NotReplayableError, match="live"):
        replay(live)


def test_a_record_keeps_what_the_robot_says_of_itself_and_when_its_day_began(run, tmp_path):
    config = tmp_path / "own.toml"
    config.write_text('[robot]\nname = "Tally"\nbegins = 2027-12-31T23:59:00\n')
    use_config(config)
    try:
        _, recorded = run("say hello")
    finally:
        forget_config()

    assert recorded.header["says_of_itself"] == {"name": "Tally", "begins": "2027-12-31T23:59:00"}
    assert replay(recorded).difference is None
