"""A failure comes back from a report as it was, also from reports that name no reasons."""

import json
from dataclasses import replace
from pathlib import Path

import jsonschema
import pytest

from executive.reports.explanation import explained
from executive.runs.recorded_failure import failure_from
from kinematics.motion.verdict import Finding, FindingKind
from trees.failures import Failure, FailureKind, OpenChoice, Reason

SCHEMA = json.loads((Path(__file__).parents[3] / "docs" / "reference" / "report.schema.json").read_text())
ELBOW = Finding(FindingKind.SCENE_COLLISION, 1.24, ("arm_left_4_link", "table"), 0.004, 0.015)
ASKED = OpenChoice(("blue cup", "red cup"), ("blue cup", "red cup 2"), "to", 1, True)


FAILURES = [
    Failure.postcondition("no cup seen", seen="table").because(Reason.NOT_SEEN).at("pick/detect"),
    Failure.asking("which cup? there are 2", ASKED),
    Failure.unsafe("too near", finding=ELBOW, step="reach"),
    Failure.unsafe("too near", finding=replace(ELBOW, place_m=(0.5, -0.1, 0.8)), step="reach"),
    Failure.infeasible("could not pick up the cup", Failure.timeout("no picture", waited_s=2.0)),
]


@pytest.mark.parametrize("failure", FAILURES)
def test_a_failure_is_read_as_it_was_written(failure):
    assert failure_from(json.loads(json.dumps(failure.to_json()))) == failure


@pytest.mark.parametrize("failure", FAILURES)
def test_a_failure_is_written_as_the_schema_of_reports_has_it(failure):
    jsonschema.validate(failure.to_json(), {"$ref": "#/$defs/FailureDocument", "$defs": SCHEMA["$defs"]})


def test_the_schema_of_reports_has_every_reason_that_is_told_apart():
    known = SCHEMA["$defs"]["FailureDocument"]["properties"]["reason"]["enum"]

    assert known == [reason.name for reason in Reason if reason is not Reason.KIND_ONLY]


def old(kind, message, **numbers):
    """A failure as reports have it that name no reasons."""
    return {"kind": kind, "where": "", "message": message, "numbers": numbers, "cause": None}


def test_a_failure_without_a_reason_has_the_one_of_every_kind():
    failure = failure_from(old("POSTCONDITION", "no cup seen", seen="table", lost=True))

    assert failure.reason is Reason.KIND_ONLY
    assert failure.numbers == {"seen": "table"}


def test_choices_that_stand_among_the_numbers_are_found():
    numbers = {"choices": "blue cup | red cup", "objects": "blue cup | red cup 2", "slot": "to", "unseen": 1}

    failure = failure_from(old("INFEASIBLE", "which cup?", **numbers, one_will_do=True))

    assert failure.open_choice == ASKED
    assert failure.numbers == {"choices": "blue cup | red cup"}


def test_what_the_checker_found_that_stands_among_the_numbers_is_explained():
    numbers = {"finding": "scene collision", "subject": "arm_left_4_link and table"}

    failure = failure_from(old("UNSAFE", "too near", **numbers, t_s=1.24, value=0.004, limit=0.015))

    assert failure.kind is FailureKind.UNSAFE
    assert failure.finding == ELBOW
    assert any("would come within 4 mm of table" in line for line in explained(failure))
