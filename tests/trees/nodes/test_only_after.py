from py_trees.common import Status

from trees.failures import Failure, FailureKind
from trees.nodes.leaf import DONE, RUNNING
from trees.nodes.skipping import OnlyAfter


def test_the_child_runs_after_a_failure_of_its_kind(stage, probe_leaf):
    child = probe_leaf("go home", stage.toolbox, RUNNING, DONE)
    node = OnlyAfter(child, frozenset({FailureKind.UNSAFE}))

    assert stage.run(node, failure=Failure.unsafe("too close")) is Status.SUCCESS
    assert child.begun == 1


def test_the_child_is_skipped_after_any_other(stage, probe_leaf):
    child = probe_leaf("go home", stage.toolbox, RUNNING, DONE)
    node = OnlyAfter(child, frozenset({FailureKind.UNSAFE}))

    assert stage.run(node, failure=Failure.postcondition("moved")) is Status.SUCCESS
    assert child.begun == 0
