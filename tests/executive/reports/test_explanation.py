"""Each kind of failure, brought about on purpose, is explained with its leaf, its cause and its numbers."""

from pathlib import Path

import pytest

from executive.reports.explanation import ADVICE, MEANINGS, explained, in_a_sentence, leaf_of
from kinematics.motion.verdict import Finding, FindingKind, Unsafe
from kinematics.requests.check import CheckRequest
from kinematics.requests.step import NoPlan
from trees.failures import Failure, FailureKind, OpenChoice

DOCS = Path(__file__).parents[3] / "docs"
GUIDE = DOCS / "guides" / "why.md"


def elbow_meets_table(request: CheckRequest) -> Unsafe:
    return Unsafe((Finding(FindingKind.SCENE_COLLISION, 1.24, ("arm_left_4_link", "table"), 0.004, 0.015),))


def nothing_red(on):
    on.fake.world.hidden.add("a")


def no_grasp(on):
    on.fake.planning.no_plan = NoPlan(
        "no way to grasp the red cup with the left or right hand was found",
        {"in collision": 64},
        {"reach_m": 0.71},
    )


def unsafe(on):
    on.fake.planning.unsafe = elbow_meets_table


def gate(on):
    on.fake.motion.refuse_midway = "velocity of arm_left_4_joint 3.2, limit 2.7"


def empty_hands(on):
    for gripper in on.fake.grippers.values():
        gripper.empty = True


def stuck(on):
    on.fake.robot.stuck.update(name for name in on.fake.model.joints if name.startswith("arm_left"))


def no_pictures(on):
    on.fake.detector.frozen = True


def broken_planner(on):
    on.fake.planning.raises = ZeroDivisionError("division by zero")


CASES = {
    "the cup is not there": (nothing_red, "", FailureKind.POSTCONDITION),
    "the fingers close on nothing": (empty_hands, "", FailureKind.POSTCONDITION),
    "no grasp is free": (no_grasp, "plan pick", FailureKind.INFEASIBLE),
    "the arm would come too near to the table": (unsafe, "plan pick", FailureKind.UNSAFE),
    "the gate refuses a setpoint": (gate, "stream reach", FailureKind.REFUSED),
    "the wrist does not follow": (stuck, "stream reach", FailureKind.EXECUTION),
    "the camera delivers no pictures": (no_pictures, "", FailureKind.TIMEOUT),
    "the planner has a defect": (broken_planner, "plan pick", FailureKind.ERROR),
    "somebody cancels": (None, "stream reach", FailureKind.CANCELED),
}


def failure_of(on, cause, step):
    """Bring a failure about once a step has begun."""
    ticket, begun = on.requests.submit("pick up the red cup"), [not step]

    def hear(event):
        begun[0] = begun[0] or (
            getattr(event, "where", "").endswith(f"/{step}") and event.status == "running"
        )

    ticket.subscribe(hear)
    while not begun[0]:
        ticket.advance()
    if cause is None:
        ticket.cancel("cancelled from the keyboard")
    else:
        cause(on)
    return ticket.result()[0].failure


def row(name, failure):
    return f"| {name} | {failure.root.kind.value} | {in_a_sentence(failure)} |"


@pytest.mark.requirement("S9")
@pytest.mark.parametrize("name", CASES)
def test_each_kind_of_failure_names_its_leaf_cause_and_numbers(fake_stage, name):
    cause, step, kind = CASES[name]

    failure = failure_of(fake_stage(), cause, step)

    lines = list(explained(failure))
    assert failure.root.kind is kind, lines
    assert lines[0].startswith("what happened: ")
    assert any(line.startswith("why: ") for line in lines)
    assert f"what helps: {ADVICE[kind]}" in lines
    if kind is not FailureKind.CANCELED:
        assert leaf_of(failure.root)
    assert row(name, failure) in GUIDE.read_text(), row(name, failure)


def test_every_kind_has_a_meaning_in_the_guide():
    text = GUIDE.read_text()

    assert set(MEANINGS) == set(ADVICE) == set(FailureKind)
    for kind, meaning in MEANINGS.items():
        assert f"| {kind.value} | {meaning} | {ADVICE[kind]} |" in text


def test_every_kind_has_the_same_meaning_where_failures_are_explained():
    text = (DOCS / "understand" / "failures.md").read_text()

    assert [kind for kind in FailureKind if f"| {kind.value} | {MEANINGS[kind]} |" not in text] == []


def test_a_question_that_nobody_answered_tells_what_to_choose_from():
    failure = Failure.asking("which cup? there are 2", OpenChoice(("blue cup", "red cup")))

    lines = list(explained(failure))

    assert lines[-1] == "what helps: say which one is meant: blue cup or red cup"
    assert not any(line.startswith("numbers: ") for line in lines)
