"""A run as something to scrub through."""

import numpy as np
import pytest

from executive.doors.view.recording import (
    MOMENT_EVERY_S,
    Moment,
    Recording,
    first_difference,
    recorded_again,
)
from executive.doors.view.shown_run import seen_at
from executive.runs.run import perform
from executive.runs.run_log import RecordedRun, recorded_runs
from executive.runs.run_request import RunRequest
from executive.screens.display import NoDisplay
from executive.scripts.task_script import script_for
from executive.trust import Trust
from trees.failures import Failure

HEADER = {"robot": "talos", "scene": "tabletop", "input": "wave"}


def node(message):
    return {"depth": 0, "name": "pick", "status": "running", "message": message}


@pytest.fixture
def recording(tmp_path):
    """Ten moments, a failed step, and a failed task."""
    made = Recording(RecordedRun(tmp_path, HEADER, {}))
    for i in range(10):
        made.moments.append(Moment(0.1 * i, None, {"things": []}, [node(str(i))]))
    failure = Failure.postcondition("it slipped").to_json()
    made.events += [
        {"event": "TaskAccepted", "t_s": 0.1, "text": "pick up the cup"},
        {"event": "LeafFailed", "t_s": 0.35, "failure": failure},
        {"event": "TaskEnded", "t_s": 0.6, "text": "pick up the cup", "failure": failure, "evidence": {}},
    ]
    return made


def test_a_time_between_moments_is_the_moment_before(recording):
    assert recording.moment(0.25).nodes[0]["message"] == "2"
    assert recording.moment(-1.0).nodes[0]["message"] == "0"
    assert recording.moment(99.0).nodes[0]["message"] == "9"


def test_failures_are_jumped_to_in_turn_and_from_the_last_to_the_first(recording):
    first = recording.next_failure_s(0.0)
    second = recording.next_failure_s(first)

    assert (first, second, recording.next_failure_s(second)) == (0.35, 0.6, 0.35)


def test_a_run_without_a_failure_has_none_to_jump_to(tmp_path):
    assert Recording(RecordedRun(tmp_path, HEADER, {})).next_failure_s(0.0) is None


def test_words_are_those_of_the_moment(recording):
    before, under_way, failed, ended = (seen_at(recording, t_s) for t_s in (0.05, 0.2, 0.4, 0.8))

    assert (before.task, under_way.task, failed.task, ended.task) == (
        None,
        "pick up the cup",
        "pick up the cup",
        None,
    )
    assert under_way.failure is None
    assert failed.failure["message"] == ended.failure["message"] == "it slipped"


@pytest.mark.timeout(300)
def test_a_recorded_run_is_seen_again_in_motion_with_its_tree_and_log(tmp_path):
    text, trust = "move backward for 1 second", Trust()
    said = script_for(text, trust, "tabletop")
    perform(
        RunRequest(
            input=text,
            statements=said.statements,
            robot="talos",
            scene="tabletop",
            seed=2,
            record=tmp_path,
            trust=trust,
        ),
        NoDisplay(),
    )
    (run,) = recorded_runs(tmp_path)
    recording, verdict = recorded_again(run, lambda _line: None)

    assert verdict.difference is None
    times = [one.t_s for one in recording.moments]
    assert np.diff(times) == pytest.approx(MOMENT_EVERY_S, abs=0.003)
    joints = np.array([one.report.sensed.readings.q for one in recording.moments])
    assert np.ptp(joints, axis=0).max() > 0.1
    places = [one.report.sensed.q[0] for one in recording.moments]
    assert places[0] - places[-1] > 0.05
    assert any(one["status"] == "running" for one in recording.moment(0.5 * recording.ends_s).nodes)
    assert any("accepted" in line.text for line in recording.log)
    assert seen_at(recording, recording.ends_s).task is None


def with_events(tmp_path, *events):
    made = Recording(RecordedRun(tmp_path, HEADER, {}))
    made.events += [{"event": kind, "t_s": t_s, "text": text} for kind, t_s, text in events]
    return made


def test_the_first_event_that_differs_is_told_with_its_time(tmp_path):
    one = with_events(tmp_path, ("TaskAccepted", 0.1, "wave"), ("Said", 1.0, "hi"), ("Said", 2.0, "bye"))
    other = with_events(tmp_path, ("TaskAccepted", 0.1, "wave"), ("Said", 0.8, "ho"), ("Said", 2.0, "bye"))

    differs = first_difference(one, other)
    assert (differs.t_s, differs.number) == (0.8, 2)
    assert ("hi" in differs.first, "ho" in differs.second) == (True, True)


def test_a_run_that_ends_before_the_other_differs_there(tmp_path):
    one = with_events(tmp_path, ("TaskAccepted", 0.1, "wave"))
    other = with_events(tmp_path, ("TaskAccepted", 0.1, "wave"), ("Said", 0.8, "ho"))

    assert first_difference(one, other).first == ""
    assert first_difference(one, one) is None


def test_what_is_told_of_one_run_alone_is_no_difference(tmp_path):
    one = with_events(
        tmp_path, ("TaskAccepted", 0.1, "wave"), ("SensorsNoted", 0.5, "ab"), ("Said", 1.0, "hi")
    )
    other = with_events(tmp_path, ("TaskAccepted", 0.1, "wave"), ("Said", 1.0, "hi"))

    assert first_difference(one, other) is None


def test_a_question_is_shown_until_it_is_answered(recording):
    recording.events[1:1] = [
        {"event": "QuestionAsked", "t_s": 0.2, "question": "which cup?", "choices": ["red", "blue"]},
        {"event": "InputTaken", "t_s": 0.3, "what": "answer", "value": "red"},
    ]

    assert seen_at(recording, 0.25).question == {"text": "which cup?", "choices": ["red", "blue"]}
    assert seen_at(recording, 0.32).question is None


def test_what_people_are_told_counts_before_what_is_for_the_digest(tmp_path):
    one = with_events(tmp_path, ("SensorsNoted", 0.5, "ab"), ("Said", 1.0, "hi"))
    other = with_events(tmp_path, ("SensorsNoted", 0.5, "cd"), ("Said", 1.0, "ho"))
    alike = with_events(tmp_path, ("SensorsNoted", 0.5, "cd"), ("Said", 1.0, "hi"))

    assert first_difference(one, other).t_s == 1.0
    assert first_difference(one, alike).t_s == 0.5
