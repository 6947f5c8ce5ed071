"""What the page makes of events and failures."""

import pytest

from executive.doors.view.seen import log_line, refused_pair, result_line
from kinematics.motion.verdict import Finding, FindingKind
from trees.failures import Failure, FailureKind


@pytest.mark.parametrize(
    ("event", "level"),
    [("Said", "said"), ("LeafFailed", "warning"), ("EmergencyStopped", "alarm"), ("TaskAccepted", "info")],
)
def test_a_line_has_the_level_of_its_event(event, level):
    assert log_line({"event": event, "t_s": 2.0}, "something").level == level


def test_steps_of_the_tree_are_the_trees_to_tell():
    assert log_line({"event": "NodeChanged", "t_s": 2.0}, "EXECUTING: x") is None


def test_what_has_nothing_for_people_is_no_line():
    assert log_line({"event": "Measured", "t_s": 2.0}, None) is None


@pytest.mark.parametrize(
    ("text", "level"),
    [("done: it waves", "info"), ("failed: it does not", "error"), ("refused: busy", "error")],
)
def test_an_order_that_has_ended_is_told(text, level):
    assert result_line(text, 1.0).level == level


@pytest.mark.parametrize("text", ["[   1.00 s] done: x", "EXECUTING: pick", "  1  the red one"])
def test_what_is_told_on_the_way_is_no_result(text):
    assert result_line(text, 1.0) is None


def finding(kind, *subject):
    return Finding(kind, 0.5, subject, 0.001, 0.01)


def test_the_pair_of_a_refused_motion_is_that_of_the_innermost_finding():
    near = finding(FindingKind.SCENE_COLLISION, "arm_left_5_link", "table")
    failure = Failure(FailureKind.EXECUTION, "no way", cause=Failure.unsafe("too near", finding=near))

    assert refused_pair(failure.to_json()) == ("arm_left_5_link", "table")


def test_a_limit_is_no_pair():
    fast = finding(FindingKind.VELOCITY_LIMIT, "arm_left_5_joint")

    assert refused_pair(Failure.unsafe("too fast", finding=fast).to_json()) == ()
    assert refused_pair(None) == ()
