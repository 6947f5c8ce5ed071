"""A failure says why in types that programs decide by, and leaves its numbers to people."""

import pytest

from kinematics.requests.step import NoPlan, WhyNoPlan
from trees.failures import Failure, FailureKind, OpenChoice, Reason
from trees.nodes.plan_failures import no_plan_failure


@pytest.mark.parametrize("reason", Reason)
def test_every_reason_has_its_meaning(reason):
    assert len(reason.value.split()) > 4


@pytest.mark.parametrize(
    ("reason", "unseen"),
    [(Reason.NOT_SEEN, True), (Reason.LOST_FROM_VIEW, True), (Reason.SEEN_FROM_AFAR, True)]
    + [(reason, False) for reason in (Reason.KIND_ONLY, Reason.OUT_OF_VIEW, Reason.SLIPPED)],
)
def test_what_no_look_showed_is_told_by_the_reason_at_the_root(reason, unseen):
    root = Failure.postcondition("no cup", seen="table").because(reason)

    assert Failure.postcondition("could not pick up the cup", root).is_unseen is unseen


def test_the_choices_are_those_at_the_root():
    root = Failure.asking("on which?", OpenChoice(("table", "desk"), ("table", "table 2"), "on"))
    failure = Failure.infeasible("could not put it down", root)

    assert (failure.choices, failure.choice_names) == (("table", "desk"), ("table", "table 2"))
    assert (failure.choice_slot, root.kind, root.reason) == ("on", FailureKind.INFEASIBLE, Reason.SEVERAL_FIT)


def test_a_failure_that_asks_nothing_has_no_choices():
    assert Failure.error("it broke").choices == Failure.error("it broke").choice_names == ()


@pytest.mark.parametrize("why", WhyNoPlan)
def test_what_planners_tell_apart_is_told_apart_as_failures(why):
    reason = no_plan_failure(NoPlan("no", {}, why=why)).reason

    assert (reason is Reason.KIND_ONLY) is (why is WhyNoPlan.NO_WAY)
