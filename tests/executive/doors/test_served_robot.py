"""A served robot from the side of a door."""

import pytest

from executive.doors import served_robot
from executive.doors.served_robot import ServedRobot

TASK = "wave"


@pytest.fixture
def robot(served):
    return ServedRobot(served.folder.path)


def ended(run):
    seen = 0
    while not run.ended:
        seen = run.wait(seen, 1.0)
    return run.status()


def asked(run):
    seen = 0
    while run.status().question is None:
        seen = run.wait(seen, 1.0)
    return run.status()


@pytest.mark.requirement("S9")
def test_a_task_tells_its_lines_and_how_it_ended(robot):
    told = ended(robot.begin(TASK))

    assert (told.outcome, told.message, told.lines) == ("done", "done: it waves", ("EXECUTING: it",))


@pytest.mark.requirement("L6")
def test_a_question_is_told_with_its_choices_and_its_answer_goes_on(served, robot):
    served.asks = True
    run = robot.begin(TASK)

    assert asked(run).question == {"text": "which cup?", "choices": ["red", "blue"]}
    assert robot.answer("red")
    assert ended(run).outcome == "done"


@pytest.mark.requirement("L6")
def test_a_question_that_comes_before_its_answer_was_taken_note_of_stays_open(served, robot, monkeypatch):
    served.asks = True
    run = robot.begin(TASK)
    asked(run)
    again = {
        "type": "question",
        "text": "which cup?",
        "choices": ["red"],
        "tried": "'x' is none of the choices",
    }

    def ask_at(_path, _message):
        run._take(again)
        return {"asked": True}

    monkeypatch.setattr(served_robot, "ask_at", ask_at)
    assert robot.answer("x")

    assert run.status().question == {
        "text": "which cup?", "choices": ["red"], "tried": "'x' is none of the choices"
    }  # fmt: skip


@pytest.mark.requirement("S7")
def test_a_pause_and_a_resume_without_a_task_do_nothing(robot):
    assert not robot.pause("a moment")
    assert not robot.resume()


@pytest.mark.requirement("S7")
def test_a_cancel_reaches_the_task_with_its_reason(served, robot):
    served.holds = True
    run = robot.begin(TASK)
    while not run.status().lines:
        run.wait(0, 1.0)

    assert robot.cancel("enough")
    assert ended(run).outcome == "cancelled"
    assert served.cancels == ["enough"]


def test_a_stop_goes_to_the_control_socket(served, robot):
    robot.stop("the red button", 2)

    assert [(one["category"], one["reason"]) for one in served.stops] == [(2, "the red button")]


def test_news_are_told_once_and_the_result_among_them(robot):
    run = robot.begin(TASK)
    ended(run)
    first, count = run.news(0)

    assert first[-1] == "done: it waves"
    assert run.news(count) == ((), count)


def test_the_last_task_is_found_without_its_name(robot):
    first, second = robot.begin(TASK), robot.begin(TASK)
    ended(first), ended(second)

    assert robot.run() is second
    assert robot.run(first.name) is first
    assert robot.run("run-9") is None
