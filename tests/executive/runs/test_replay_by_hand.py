"""A run that a person has jogged comes out the same again, or it is said what of it was not recorded."""

import json

import numpy as np
import pytest

from executive.dialogue import attendant as attendants
from executive.manual.words import GripJog
from executive.runs.replay import NotReplayableError, replay
from executive.runs.run import perform
from executive.runs.run_log import recorded_run
from executive.runs.run_request import RunRequest
from executive.screens.display import NoDisplay
from executive.scripts.task_script import script_for
from kinematics.following.jog_reference import HandJog, JointJog

SAID = (
    HandJog("right", "world", np.array([0.0, 0.0, 0.05]), np.zeros(3)),
    JointJog("arm_left_4_joint", 0.15),
    GripJog("right", opens=True),
)


class Person(attendants.Nobody):
    """Takes over in the middle of a task or after its failure, says some words, and gives the robot back."""

    def __init__(self, ending, at_s=None):
        self.ending, self.at_s = ending, at_s
        self.words = [word for word in SAID for _ in range(10)]

    def begin(self, session):
        if self.at_s is None:
            session.hands.offer = lambda _failure: bool(self.words)

    def attend(self, session):
        feed = session.hands.feed
        if not feed.active:
            if self.at_s is not None and session.now_s >= self.at_s:
                self.at_s = None
                feed.take_over()
            return
        if not self.words:
            feed.hand_back(self.ending)
            return
        word = self.words.pop(0)
        feed.may_touch = isinstance(word, GripJog)
        if len(self.words) % 4 == 0:
            feed.brake()
        else:
            feed.say(word, session.now_s)


def recorded(folder, text, person):
    request = RunRequest(text, script_for(text).statements, "talos", "tabletop", 3, folder)
    return perform(request, NoDisplay(), person), recorded_run(folder, "latest")


def events(run):
    return [json.loads(line) for line in (run.path / "events.jsonl").read_text().splitlines()]


@pytest.fixture(scope="module")
def jogged(tmp_path_factory):
    return recorded(tmp_path_factory.mktemp("runs"), "pick up the red cup", Person("give_up", at_s=0.6))


@pytest.mark.requirement("U1", "S10")
def test_a_task_that_a_person_took_over_comes_out_the_same(jogged):
    performance, run = jogged

    verdict = replay(run)

    assert verdict.difference is None
    assert performance.report.outcome == "cancelled"
    assert sum(event.get("what") == "jog" for event in events(run)) > 20


@pytest.mark.requirement("U1", "S10")
def test_so_does_one_that_had_failed_before(tmp_path):
    performance, run = recorded(tmp_path, "walk forward 2 meters", Person("go_on"))

    verdict = replay(run)

    assert verdict.difference is None
    assert [event["value"] for event in events(run) if event.get("what") in ("take_over", "hand_back")] == [
        "after its failure",
        "go_on",
    ]
    assert performance.report.outcome == "failed"


@pytest.mark.requirement("S10")
def test_evidence_and_report_say_that_a_person_did_it(jogged):
    performance, run = jogged

    assert performance.report.to_json()["tasks"][0]["evidence"]["by"] == "person"
    assert json.loads((run.path / "report.json").read_text())["tasks"][0]["evidence"]["by"] == "person"
    assert [event["evidence"]["by"] for event in events(run) if event["event"] == "TaskEnded"] == ["person"]


@pytest.mark.parametrize(
    ("what", "value", "reason"),
    [
        ("take_over", "a person", "what was said to the robot then was not recorded"),
        ("jog", '{"hand": "third"}', "no word of a person"),
        ("jog", "up", "a person jogged the robot"),
        ("hand_back", "sold", "given back by 'sold'"),
    ],
)
def test_a_record_without_a_persons_words_says_so(jogged, what, value, reason):
    _, run = jogged
    file = run.path / "events.jsonl"
    before = file.read_text()
    spoilt = [event | ({"value": value} if event.get("what") == what else {}) for event in events(run)]
    file.write_text("".join(json.dumps(event) + "\n" for event in spoilt))

    try:
        with pytest.raises(NotReplayableError, match=reason):
            replay(run)
    finally:
        file.write_text(before)
