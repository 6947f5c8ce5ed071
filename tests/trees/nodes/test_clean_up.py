from py_trees.common import Status

from trees.failures import Failure
from trees.nodes.clean_up import CleanUp
from trees.nodes.leaf import DONE, RUNNING


def always(failure):
    return True


def test_success_needs_no_cleaning_up(stage, probe_leaf):
    after = probe_leaf("after", stage.toolbox, DONE)

    assert (
        stage.run(CleanUp("task", probe_leaf("main", stage.toolbox, DONE), after, always)) is Status.SUCCESS
    )
    assert after.begun == 0


def test_a_failure_remains_one_after_cleaning_up(stage, probe_leaf):
    main = probe_leaf("main", stage.toolbox, Failure.infeasible("no way"))
    after = probe_leaf("after", stage.toolbox, RUNNING, RUNNING, DONE)
    node = CleanUp("task", main, after, always)

    assert stage.run(node) is Status.FAILURE
    assert node.failure.message == "no way"
    assert after.status is Status.SUCCESS


def test_a_failed_clean_up_does_not_hide_the_first_failure(stage, probe_leaf):
    main = probe_leaf("main", stage.toolbox, Failure.infeasible("no way"))
    node = CleanUp("task", main, probe_leaf("after", stage.toolbox, Failure.unsafe("worse")), always)

    assert stage.run(node) is Status.FAILURE
    assert node.failure.message == "no way"


def test_cleaning_up_is_left_out_where_it_is_not_worth_it(stage, probe_leaf):
    after = probe_leaf("after", stage.toolbox, DONE)
    node = CleanUp(
        "task", probe_leaf("main", stage.toolbox, ValueError("broken")), after, lambda failure: False
    )

    assert stage.run(node) is Status.FAILURE
    assert after.begun == 0
