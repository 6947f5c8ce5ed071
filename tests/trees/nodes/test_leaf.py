import pytest
from py_trees.blackboard import Blackboard
from py_trees.common import Status
from py_trees.composites import Sequence

from trees.events import LeafFailed, NotSo
from trees.failures import Failure, FailureKind
from trees.nodes.leaf import DONE, RUNNING
from trees.nodes.ports import ports


def test_a_leaf_runs_until_it_is_done(stage, probe_leaf):
    leaf = probe_leaf("probe", stage.toolbox, RUNNING, DONE)

    assert stage.run(leaf) is Status.SUCCESS
    assert leaf.failure is None
    assert leaf.released == []


def test_a_failure_gets_its_place_in_the_tree(stage, probe_leaf):
    leaf = probe_leaf("probe", stage.toolbox, Failure.infeasible("no way"))
    root = Sequence("pick", memory=True, children=[Sequence("reach", memory=True, children=[leaf])])

    assert stage.run(root) is Status.FAILURE
    assert leaf.failure.where == "pick/reach/probe"
    assert leaf.feedback_message == "no way"


def test_a_failure_is_told_and_releases_what_was_started(stage, probe_leaf):
    leaf = probe_leaf("probe", stage.toolbox, RUNNING, Failure.execution("stuck", joint="arm"))

    stage.run(leaf)

    assert [event.failure for event in stage.events if isinstance(event, LeafFailed)] == [leaf.failure]
    assert leaf.released == ["stuck"]


def test_a_leaf_that_only_asks_answers_that_it_is_not_so(stage, probe_leaf):
    leaf = probe_leaf("probe", stage.toolbox, Failure.postcondition("it stands elsewhere"))
    leaf.ASKS = True

    assert stage.run(leaf) is Status.FAILURE
    assert [event for event in stage.events if isinstance(event, LeafFailed)] == []
    assert [event.failure for event in stage.events if isinstance(event, NotSo)] == [leaf.failure]


def test_what_goes_wrong_in_a_leaf_that_only_asks_is_a_failure(stage, probe_leaf):
    leaf = probe_leaf("probe", stage.toolbox, ZeroDivisionError("by nothing"))
    leaf.ASKS = True

    stage.run(leaf)

    assert [event.failure for event in stage.events if isinstance(event, LeafFailed)] == [leaf.failure]


@pytest.mark.requirement("S8")
def test_an_exception_in_a_step_becomes_a_failure_that_names_it(stage, probe_leaf):
    leaf = probe_leaf("probe", stage.toolbox, RUNNING, ZeroDivisionError("by nothing"))

    assert stage.run(leaf) is Status.FAILURE
    assert leaf.failure.kind is FailureKind.ERROR
    assert leaf.failure.message == "ZeroDivisionError: by nothing"
    assert leaf.failure.numbers["raised_at"].startswith("conftest.py:")
    assert leaf.released


@pytest.mark.requirement("S8")
def test_an_exception_at_the_start_becomes_a_failure(stage, probe_leaf, monkeypatch):
    leaf = probe_leaf("probe", stage.toolbox, DONE)
    monkeypatch.setattr(leaf, "begin", lambda: 1 / 0)

    assert stage.run(leaf) is Status.FAILURE
    assert leaf.failure.numbers["exception"] == "ZeroDivisionError"


@pytest.mark.requirement("S8")
def test_an_exception_while_releasing_is_contained_and_keeps_its_cause(stage, probe_leaf, monkeypatch):
    leaf = probe_leaf("probe", stage.toolbox, Failure.execution("stuck"))
    monkeypatch.setattr(leaf, "release", lambda reason: 1 / 0)

    assert stage.run(leaf) is Status.FAILURE
    assert leaf.failure.kind is FailureKind.ERROR
    assert leaf.failure.cause.message == "stuck"


def test_a_leaf_that_takes_longer_than_its_deadline_fails(stage, probe_leaf):
    leaf = probe_leaf("probe", stage.toolbox, *[RUNNING] * 100)

    assert stage.run(leaf) is Status.FAILURE
    assert leaf.failure.kind is FailureKind.TIMEOUT
    assert 1.0 < leaf.failure.numbers["elapsed_s"] < 1.1
    assert leaf.released


def test_a_halted_leaf_releases_and_says_why(stage, probe_leaf):
    leaf = stage.ready(probe_leaf("probe", stage.toolbox, RUNNING, RUNNING))
    stage.tick(leaf)
    leaf.halt_reason = "somebody pressed stop"

    leaf.stop(Status.INVALID)

    assert leaf.released == ["somebody pressed stop"]
    assert leaf.failure.kind is FailureKind.CANCELED


def test_resetting_a_leaf_that_has_ended_releases_nothing(stage, probe_leaf):
    leaf = probe_leaf("probe", stage.toolbox, DONE)
    stage.run(leaf)

    leaf.stop(Status.INVALID)

    assert leaf.released == []
    assert leaf.failure is None


def test_a_leaf_starts_anew_each_time(stage, probe_leaf):
    leaf = probe_leaf("probe", stage.toolbox, Failure.execution("once"))
    stage.run(leaf)
    leaf.script = [RUNNING, DONE]

    while stage.tick(leaf) is Status.RUNNING:
        assert leaf.failure is None

    assert leaf.begun == 2
    assert leaf.elapsed_s < 0.1


def test_time_in_a_pause_does_not_count_towards_the_deadline(stage, probe_leaf):
    leaf = stage.ready(probe_leaf("work", stage.toolbox, *[Status.RUNNING] * 100))
    stage.tick(leaf)
    before_s = leaf.elapsed_s

    stage.fake.clock.advance(60.0)
    stage.toolbox.pauses.total_s += 60.0

    assert leaf.elapsed_s == pytest.approx(before_s)
    assert stage.tick(leaf) is Status.RUNNING


@pytest.fixture
def reader(stage, probe_leaf):
    """A leaf that reads a number."""

    class Reader(probe_leaf, register=False):
        INPUT_PORTS = ports(count=int)

    leaf = Reader("reader", stage.toolbox)
    leaf.wiring = {"count": "how_many"}
    return leaf


def test_a_port_is_read_where_it_is_wired_to_in_the_tree_of_the_leaf(reader):
    Blackboard.set("/one/how_many", 1)
    Blackboard.set("/other/how_many", 2)

    reader.wire("/one")
    first = reader.get_input("count")
    reader.wire("/other")

    assert (first, reader.get_input("count")) == (1, 2)


def test_what_is_not_of_the_type_of_its_port_is_refused(reader):
    reader.wire("/one")
    Blackboard.set("/one/how_many", "three")

    with pytest.raises(TypeError, match="is not of type"):
        reader.get_input("count")


def test_a_port_that_is_not_declared_cannot_be_read_though_something_is_there(reader):
    reader.wire("/one")
    Blackboard.set("/one/length", 4)

    with pytest.raises(KeyError, match="not defined"):
        reader.get_input("length")
