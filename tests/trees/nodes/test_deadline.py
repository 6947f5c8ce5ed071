from py_trees.common import Status

from trees.failures import Failure, FailureKind
from trees.nodes.deadline import Deadline
from trees.nodes.leaf import DONE, RUNNING


def test_a_child_in_time_passes(stage, probe_leaf):
    node = Deadline("in time", probe_leaf("work", stage.toolbox, RUNNING, DONE), 0.5, stage.fake.clock)

    assert stage.run(node) is Status.SUCCESS
    assert node.failure is None


def test_a_child_that_takes_too_long_is_halted(stage, probe_leaf):
    child = probe_leaf("work", stage.toolbox, *[RUNNING] * 50)
    node = Deadline("in time", child, 0.5, stage.fake.clock)

    assert stage.run(node) is Status.FAILURE
    assert node.failure.kind is FailureKind.TIMEOUT
    assert node.failure.numbers["deadline_s"] == 0.5
    assert child.released


def test_the_clock_starts_with_the_first_tick(stage, probe_leaf):
    node = Deadline("in time", probe_leaf("work", stage.toolbox, RUNNING, DONE), 0.5, stage.fake.clock)
    stage.fake.clock.advance(3.0)

    assert stage.run(node) is Status.SUCCESS


def test_a_failure_is_passed_on(stage, probe_leaf):
    failure = Failure.unsafe("too close")
    node = Deadline("in time", probe_leaf("work", stage.toolbox, failure), 0.5, stage.fake.clock)

    assert stage.run(node) is Status.FAILURE
    assert node.failure.kind is FailureKind.UNSAFE


def test_time_in_a_pause_does_not_count(stage, probe_leaf):
    leaf = probe_leaf("work", stage.toolbox, RUNNING, RUNNING, RUNNING)
    node = Deadline("in time", leaf, 0.5, stage.fake.clock, stage.toolbox.pauses)
    stage.ready(node)
    stage.tick(node)

    stage.fake.clock.advance(0.8)
    stage.toolbox.pauses.total_s += 0.8

    assert stage.tick(node) is RUNNING
