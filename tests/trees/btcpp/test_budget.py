"""What a document may multiply to: one budget of nodes and one of depth, sub-trees written out."""

import pytest
from py_trees.common import Status

from tests.trees.example_tasks import TASKS, root_of
from trees.btcpp.document import MOST_NODES, NESTED_MOST
from trees.btcpp.errors import TreeDocumentError
from trees.btcpp.reader import read_tree
from trees.btcpp.writer import write_tree


def document(**trees):
    bodies = "".join(f'<BehaviorTree ID="{name}">{body}</BehaviorTree>' for name, body in trees.items())
    return f'<root BTCPP_format="4" main_tree_to_execute="t0">{bodies}</root>'


def doubling(times):
    twice = {
        f"t{k}": f'<Sequence><SubTree ID="t{k + 1}"/><SubTree ID="t{k + 1}"/></Sequence>'
        for k in range(times)
    }
    return document(**twice, **{f"t{times}": "<AlwaysSuccess/>"})


def nested(trees, inverters, remap=""):
    deep = {
        f"t{k}": "<Inverter>" * inverters + f'<SubTree ID="t{k + 1}"{remap}/>' + "</Inverter>" * inverters
        for k in range(trees)
    }
    return document(**deep, **{f"t{trees}": "<AlwaysSuccess/>"})


def refusal(text, stage):
    with pytest.raises(TreeDocumentError) as caught:
        read_tree(text, stage.toolbox)
    return str(caught.value)


def test_sub_trees_that_multiply_are_refused_before_any_node_is_made(stage):
    assert f"more than {MOST_NODES} nodes" in refusal(doubling(30), stage)


def test_sub_trees_that_multiply_within_the_budget_are_read(stage):
    assert len(list(read_tree(doubling(8), stage.toolbox).iterate())) == 2**9 - 1


def test_sub_trees_that_nest_too_deep_together_are_refused(stage):
    assert f"deeper than {NESTED_MOST} nodes" in refusal(nested(30, 150), stage)


@pytest.mark.parametrize("remap", ["", ' _autoremap="true"'])
def test_a_chain_of_trees_is_refused_by_its_depth_however_its_keys_are_handed_on(stage, remap):
    assert f"deeper than {NESTED_MOST} nodes" in refusal(nested(5000, 0, remap), stage)


@pytest.mark.parametrize(
    ("trees", "inverters"), [(1, NESTED_MOST - 2), (NESTED_MOST - 1, 0), (NESTED_MOST // 2 - 1, 1)]
)
def test_the_deepest_tree_that_is_read_can_be_ticked_written_and_halted(stage, trees, inverters):
    root = read_tree(nested(trees, inverters, ' _autoremap="true"'), stage.toolbox)

    for _ in root.tick():
        pass
    root.stop(Status.INVALID)
    assert read_tree(write_tree(root), stage.toolbox).name == root.name


@pytest.mark.parametrize("nodes", [MOST_NODES, MOST_NODES + 1])
def test_the_budget_is_for_all_nodes_of_a_wide_tree_too(stage, nodes):
    row = f"<Sequence>{'<AlwaysSuccess/>' * 998}</Sequence>"
    text = document(t0=f"<Sequence>{row * 10}{'<AlwaysSuccess/>' * (nodes - 1 - 10 * 999)}</Sequence>")

    if nodes > MOST_NODES:
        assert f"more than {MOST_NODES} nodes" in refusal(text, stage)
    else:
        assert len(list(read_tree(text, stage.toolbox).iterate())) == nodes


def test_a_ring_of_trees_is_still_told_as_one(stage):
    ring = document(t0='<SubTree ID="t1"/>', t1='<Sequence><SubTree ID="t0"/></Sequence>')

    assert "the tree 't0' is within itself" in refusal(ring, stage)


def test_trees_that_nothing_refers_to_count_for_nothing(stage):
    spare = {
        f"s{k}": f'<Sequence><SubTree ID="s{k + 1}"/><SubTree ID="s{k + 1}"/></Sequence>' for k in range(30)
    }

    assert read_tree(document(t0="<GoHome/>", **spare, s30="<GoHome/>"), stage.toolbox).name == "GoHome"


@pytest.mark.parametrize("task", TASKS.values(), ids=lambda task: task.action)
def test_every_skill_is_far_within_the_budget(task, stage):
    tree = root_of(task, stage.toolbox)

    assert len(list(tree.iterate())) < MOST_NODES / 4
