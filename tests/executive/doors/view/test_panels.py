"""What the page tells in words."""

import re

import pytest

from executive.doors.view.panels import (
    ending_panel,
    found_panel,
    log_panel,
    question_panel,
    running_leaf,
    status_panel,
    tree_panel,
)
from executive.doors.view.seen import LogLine, Seen
from executive.doors.view.shown_lines import lines_of
from trees.failures import Failure, FailureKind


def node(depth, name, status="idle", message=""):
    return {"depth": depth, "name": name, "status": status, "message": message}


TREE = [
    node(0, "pick", "running"),
    node(1, "look", "success"),
    node(2, "aim", "success"),
    node(1, "reach", "running"),
    node(2, "plan", "success"),
    node(2, "follow", "running", "62 %"),
    node(1, "lift"),
    node(2, "rise"),
]


def words(html):
    return re.sub(r"<[^>]+>", " ", html)


def test_branches_that_are_over_or_have_not_begun_are_folded():
    told = words(tree_panel(lines_of(TREE, {})))

    assert "aim" not in told
    assert "rise" not in told
    assert all(name in told for name in ("look", "reach", "plan", "follow", "lift"))


def test_all_is_shown_when_asked_for():
    assert all(one["name"] in words(tree_panel(lines_of(TREE, {}, unfolded=True))) for one in TREE)


def test_a_search_shows_what_it_finds_and_what_that_is_in():
    told = words(found_panel(TREE, "FOLL"))

    assert all(name in told for name in ("pick", "reach", "follow"))
    assert not any(name in told for name in ("look", "plan", "lift"))


def test_the_current_leaf_is_the_last_that_runs():
    assert running_leaf(TREE)["name"] == "follow"
    assert running_leaf([node(0, "pick", "success")]) is None


def test_the_status_tells_task_and_current_leaf():
    told = words(status_panel(Seen("talos", "flat", 3.0, "NORMAL", task="pick up the cup", nodes=TREE)))

    assert "pick up the cup" in told
    assert "follow" in told
    assert "62 %" in told


def test_an_emergency_stop_and_a_silent_executive_are_told():
    told = words(status_panel(Seen(emergency="STOP in the browser", complaint="no answer")))

    assert "EMERGENCY STOP: STOP in the browser" in told
    assert "no answer" in told


@pytest.mark.requirement("U6")
def test_a_failure_is_told_link_by_link_with_its_numbers():
    cause = Failure.postcondition("nothing between the fingers", opening_m=0.001).at("pick/close")
    failure = Failure(FailureKind.EXECUTION, "the cup was not picked up", cause=cause)
    told = words(ending_panel(Seen(failure=failure.to_json())))

    assert told.index("not picked up") < told.index("because: nothing between the fingers")
    assert "1.0 mm" in told
    assert "pick/close" in told


def test_evidence_is_told_in_units():
    assert "opening 61.0 mm" in words(ending_panel(Seen(evidence={"opening_m": 0.061})))
    assert ending_panel(Seen()) == ""


def test_a_log_is_shown_from_a_level_on():
    log = (LogLine(1.0, "looks"), LogLine(2.0, "slips", "warning"), LogLine(3.0, "says hi", "said"))

    assert "looks" in words(log_panel(log))
    assert [text in words(log_panel(log, "warning")) for text in ("looks", "slips", "says hi")] == [
        False,
        True,
        False,
    ]


@pytest.mark.parametrize(
    "html",
    [
        status_panel(Seen(task="<script>alert(1)</script>", complaint="<b>", emergency="<i>")),
        tree_panel(lines_of([node(0, "<script>", "running", "<img src=x>")], {})),
        log_panel([LogLine(0.0, "<script>")]),
        question_panel({"text": "<script>", "tried": "<script>"}),
        ending_panel(Seen(failure=Failure.error("<script>", **{"<b>": "<i>"}).to_json())),
        ending_panel(Seen(evidence={"<script>": "<script>"})),
    ],
)
def test_what_is_told_is_text_and_no_markup(html):
    assert not re.search(r"<(script|img)", html)
