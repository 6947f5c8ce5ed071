from py_trees.common import Status

from trees.failures import Failure
from trees.nodes.best_effort import BestEffort
from trees.nodes.leaf import RUNNING


def test_an_ordinary_failure_does_no_harm(stage, probe_leaf):
    node = BestEffort(probe_leaf("tidy", stage.toolbox, RUNNING, Failure.infeasible("no way")))

    assert stage.run(node) is Status.SUCCESS
    assert node.feedback_message == "no way"


def test_a_defect_is_passed_on(stage, probe_leaf):
    assert stage.run(BestEffort(probe_leaf("tidy", stage.toolbox, ValueError("broken")))) is Status.FAILURE
