from py_trees.common import Status

from trees.nodes.leaf import DONE
from trees.nodes.skipping import IfShifted


def test_what_has_shifted_is_planned_for_again(stage, probe_leaf):
    child = probe_leaf("plan again", stage.toolbox, DONE)

    assert stage.run(IfShifted(child), shifted=True) is Status.SUCCESS
    assert child.begun == 1


def test_what_is_where_it_was_is_not(stage, probe_leaf):
    child = probe_leaf("plan again", stage.toolbox, DONE)

    assert stage.run(IfShifted(child), shifted=False) is Status.SUCCESS
    assert child.begun == 0
