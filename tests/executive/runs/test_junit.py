"""A script's run as JUnit XML."""

import xml.etree.ElementTree as ElementTree

import pytest

from executive.meaning import Parsed, Refusal
from executive.runs.junit import junit_xml
from executive.session.task_result import TaskResult, TaskTimes
from executive.understanding.statement import Statement
from trees.failures import Failure

DONE = TaskResult("go home", "go_home", "done", times=TaskTimes(0.1, 2.5, 9.0))
FAILED = TaskResult(
    "pick", "pick", "failed", failure=Failure.infeasible("no grasp", reach_m=0.7).at("pick/plan/plan pick")
)


def suite(*results):
    return ElementTree.fromstring(junit_xml("tidy.toml", results)).find("testsuite")


def said(text, **options):
    return Statement(Parsed(text), **options)


@pytest.mark.requirement("U1")
def test_each_statement_is_a_test_case_with_its_simulated_seconds():
    found = suite((said("go home"), [DONE, DONE]))

    assert found.attrib["tests"] == "1"
    assert found.attrib["failures"] == "0"
    assert found.find("testcase").attrib["name"] == "1: go home"
    assert found.find("testcase").attrib["time"] == "5.000"


def test_a_result_that_was_not_expected_is_a_failure_with_the_chain_of_reasons():
    found = suite((said("go home"), [DONE]), (said("pick"), [FAILED]))

    failure = found.findall("testcase")[1].find("failure")
    assert found.attrib["failures"] == "1"
    assert failure.attrib["message"] == "expected done, got failed"
    assert "no grasp (reach 0.7 m) [INFEASIBLE at pick/plan/plan pick]" in failure.text


def test_an_expected_failure_is_none():
    found = suite((said("pick", expect="failed"), [FAILED]))

    assert found.attrib["failures"] == "0"
    assert "no grasp" in found.find("testcase").find("system-out").text


def test_a_refusal_says_why_and_what_xml_cannot_hold_is_replaced():
    parsed = Parsed("pick\x07up\ud800", refusal=Refusal("the word '\x07' is not known"))
    found = suite((Statement(parsed), [TaskResult("pick\x07up", "none", "refused")]))

    assert "is not known" in found.find("testcase").find("failure").text
    assert "\x07" not in found.find("testcase").attrib["name"]
