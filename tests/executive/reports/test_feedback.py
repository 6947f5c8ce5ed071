"""What people read is made from typed results, and says the numbers."""

import pytest

from executive.exit_codes import ExitCode
from executive.reports.feedback import failure_lines, line_for, quantity, result_line, result_line_of_all
from executive.session.task_result import TaskResult, TaskTimes
from robots.control.events import MotionEnded, SetpointRefused
from trees.events import LeafFailed, NodeChanged, NotSo
from trees.failures import Failure, OpenChoice

TIMES = TaskTimes(0.4, 8.4, 2.9)
PICKED = TaskResult(
    "pick up the red cup",
    "pick",
    "done",
    1,
    None,
    {"hand": "left", "gripper_opening_m": 0.061, "effort_nm": 3.41, "lift_m": 0.131},
    TIMES,
    "red cup",
)


@pytest.mark.requirement("S9")
def test_the_last_line_of_a_pick_tells_what_the_sensors_measured():
    assert result_line(PICKED) == (
        "done: red cup held in the left hand, opening 61 mm, effort 3.4 Nm, lifted 0.13 m "
        "(8.4 s simulated, 2.9 s wall)"
    )


def test_what_was_not_measured_is_not_claimed():
    unseen = TaskResult("x", "pick", "done", 1, None, {"gripper_opening_m": 0.061}, TIMES, "red cup")

    assert "lifted" not in result_line(unseen)
    assert "effort" not in result_line(unseen)


def test_several_tasks_are_told_in_order():
    home = TaskResult("go home", "go_home", "done", times=TaskTimes(0.0, 1.6, 1.0))

    line = result_line_of_all([PICKED, home])

    assert line.endswith("; then at the home posture (10.0 s simulated, 3.9 s wall)")


def test_what_was_done_after_all_is_told_as_what_it_became():
    unseen = Failure.postcondition("no red cup seen", seen="table")
    first = TaskResult("pick up the red cup", "pick", "failed", 1, unseen, {}, TIMES)
    walked = TaskResult("come within reach of the red cup", "walk_to", "done", times=TIMES)

    line = result_line_of_all([first, walked, PICKED])

    assert line.startswith("done: ")
    assert "red cup held in the left hand" in line
    assert line.endswith("(25.2 s simulated, 8.7 s wall)")


@pytest.mark.parametrize("action", ["find", "count", "describe"])
def test_the_last_line_of_a_question_is_the_answer(action):
    evidence = {"said": "there are two cups", "count": 2}

    line = result_line(TaskResult("how many cups are there", action, "done", 1, None, evidence, TIMES))

    assert line == "done: there are two cups (8.4 s simulated, 2.9 s wall)"


@pytest.mark.requirement("S9")
def test_the_last_line_of_a_failure_tells_the_root_cause():
    failure = Failure.infeasible("could not pick up the red cup", Failure.unsafe("hand touches table"))

    line = result_line(TaskResult("x", "pick", "failed", 4, failure, {}, TIMES))

    assert line.startswith("failed: could not pick up the red cup, because hand touches table [UNSAFE]")


def test_a_failure_chain_is_indented_below_what_it_caused():
    failure = Failure.infeasible("gave up", Failure.unsafe("too near", gap_m=0.004).at("pick/check")).at(
        "pick"
    )

    assert failure_lines(failure) == [
        "gave up [INFEASIBLE at pick]",
        "└─ too near (gap 4.0 mm) [UNSAFE at pick/check]",
    ]


@pytest.mark.parametrize(
    ("key", "value", "text"),
    [
        ("opening_m", 0.0612, "opening 61.2 mm"),
        ("lift_m", 0.1312, "lift 0.131 m"),
        ("speed_rad_s", 1.5, "speed 1.5 rad/s"),
        ("effort_nm", 3.46, "effort 3.46 Nm"),
        ("attempts", 4, "attempts 4"),
        ("pair", "hand and table", "pair hand and table"),
        ("seen", True, "seen True"),
    ],
)
def test_a_named_number_is_read_with_its_unit(key, value, text):
    assert quantity(key, value) == text


@pytest.mark.requirement("S9")
def test_a_running_leaf_is_announced():
    assert line_for(NodeChanged(1.0, "pick/reach", "running", "")) == "EXECUTING: pick/reach"
    assert line_for(NodeChanged(1.0, "pick/reach", "success", "")) is None


@pytest.mark.requirement("S1")
def test_a_refused_setpoint_names_the_limit_and_the_value():
    line = line_for(SetpointRefused(1.0, "reach", "velocity", "arm_left_1_joint", 3.2, 2.7))

    assert line == "refused setpoint of reach: arm_left_1_joint velocity 3.2, limit 2.7"


@pytest.mark.parametrize(
    ("status", "line"),
    [
        ("canceled", "motion stopped: the object stands"),
        ("refused", "motion walk refused: the object stands"),
    ],
)
def test_a_motion_that_was_stopped_on_purpose_is_told_as_such(status, line):
    assert line_for(MotionEnded(1.0, "walk", "motion-1", status, "the object stands")) == line


def test_several_that_fit_end_in_a_question_with_its_choices():
    root = Failure.asking("which cup? there are 2", OpenChoice(("blue cup", "red cup")))
    failure = Failure.infeasible("could not pick up the cup", root)

    result = TaskResult("pick up the cup", "pick", "question", failure=failure)

    assert result_line(result).startswith("question: which cup? there are 2: blue cup or red cup (")
    assert result.exit_code is ExitCode.QUESTION


def test_a_step_that_only_asks_whether_something_is_so_does_not_fail_when_it_is_not():
    no = Failure.postcondition("no blue can is in a hand").at("put in/have it/is it held")

    assert line_for(NotSo(1.0, no)) == "no blue can is in a hand"
    assert line_for(LeafFailed(1.0, no)).startswith("failed: no blue can is in a hand")
