from py_trees.common import Status

from trees.failures import Failure
from trees.nodes.alternatives import Alternatives
from trees.nodes.leaf import DONE, RUNNING


def test_the_next_way_is_taken_when_one_fails(stage, probe_leaf):
    first = probe_leaf("first", stage.toolbox, RUNNING, Failure.infeasible("no"))
    second = probe_leaf("second", stage.toolbox, RUNNING, DONE)

    assert stage.run(Alternatives("ways", [first, second])) is Status.SUCCESS


def test_the_last_failure_is_told_when_all_fail(stage, probe_leaf):
    ways = [probe_leaf(word, stage.toolbox, Failure.infeasible(word)) for word in ("one", "two")]
    node = Alternatives("ways", ways)

    assert stage.run(node) is Status.FAILURE
    assert node.failure.message == "two"


def test_a_defect_is_not_worked_around(stage, probe_leaf):
    second = probe_leaf("second", stage.toolbox, DONE)
    node = Alternatives("ways", [probe_leaf("first", stage.toolbox, ValueError("broken")), second])

    assert stage.run(node) is Status.FAILURE
    assert second.begun == 0


def test_a_way_that_failed_is_not_tried_again_while_another_runs(stage, probe_leaf):
    first = probe_leaf("first", stage.toolbox, Failure.infeasible("no"))
    node = Alternatives("ways", [first, probe_leaf("second", stage.toolbox, RUNNING, RUNNING, DONE)])

    stage.run(node)

    assert first.begun == 1
