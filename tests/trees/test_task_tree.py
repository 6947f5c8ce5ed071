import pytest
from py_trees.blackboard import Blackboard
from py_trees.composites import Sequence

from trees.events import NodeChanged
from trees.failures import FailureKind
from trees.nodes.judgements import place_of
from trees.nodes.leaf import DONE, RUNNING
from trees.nodes.snapshot_of import status_word
from trees.task_tree import TaskTree
from trees.tasks import GoHomeTask

TASK = GoHomeTask("go home")


class Broken(Sequence):
    """A node between leaves that raises on its second tick."""

    def tick(self):
        if self.status.value == "RUNNING":
            raise KeyError("lost")
        yield from super().tick()


def test_nothing_happens_before_the_first_tick(stage, probe_leaf):
    leaf = probe_leaf("probe", stage.toolbox, DONE)
    tree = TaskTree(TASK, leaf, stage.toolbox)

    assert (tree.status, leaf.begun, stage.events) == ("running", 0, [])


def test_ticks_after_the_end_do_nothing(stage, probe_leaf):
    leaf = probe_leaf("probe", stage.toolbox, DONE)
    tree = TaskTree(TASK, leaf, stage.toolbox)
    tree.tick()
    tree.tick()
    tree.halt("too late")

    assert (tree.status, tree.failure, leaf.begun) == ("success", None, 1)


def test_every_change_of_every_node_is_told_once_and_in_the_trees_order(stage):
    stage.when("verify lift", lambda: stage.fake.world.remove("red cup"))
    tree = stage.pick()
    nodes = list(tree.root.iterate())
    before = [node.status for node in nodes]

    while tree.status == "running":
        stage.events.clear()
        stage.play(tree, 1)

        now = [node.status for node in nodes]
        changed = [node for node, old, new in zip(nodes, before, now, strict=True) if old is not new]
        told = [(event.where, event.status) for event in stage.events if isinstance(event, NodeChanged)]
        assert told == [(place_of(node), status_word(node)) for node in changed]
        before = now


@pytest.mark.requirement("S8")
def test_a_node_that_raises_fails_the_task_and_stops_its_leaves(stage, probe_leaf):
    leaf = probe_leaf("probe", stage.toolbox, RUNNING, RUNNING, RUNNING)
    tree = TaskTree(TASK, Broken("broken", memory=True, children=[leaf]), stage.toolbox)

    tree.tick()
    tree.tick()

    assert tree.status == "failure"
    assert tree.failure.kind is FailureKind.ERROR
    assert tree.failure.numbers["exception"] == "KeyError"
    assert leaf.released


def test_a_snapshot_shows_every_node_with_its_status_and_message(stage, probe_leaf):
    first, second = probe_leaf("first", stage.toolbox, DONE), probe_leaf("second", stage.toolbox, RUNNING)
    tree = TaskTree(TASK, Sequence("both", memory=True, children=[first, second]), stage.toolbox)
    second.feedback_message = ""
    tree.tick()

    shown = tree.snapshot(0.3)
    assert (shown.t_s, shown.tick) == (0.3, 1)
    assert (shown.root.name, shown.root.kind, shown.root.status) == ("both", "sequence", "running")
    assert [(child.name, child.kind, child.status) for child in shown.root.children] == [
        ("first", "leaf", "success"),
        ("second", "leaf", "running"),
    ]


def test_only_leaves_have_a_leaf_place_whatever_the_branches_are_called(stage, probe_leaf):
    branch = Sequence("look", memory=True, children=[probe_leaf("look", stage.toolbox, DONE)])
    tree = TaskTree(TASK, Sequence("pick", memory=True, children=[branch]), stage.toolbox)

    assert tree.leaf_places == {"pick/look/look"}


def test_a_snapshot_of_a_pick_names_all_kinds_of_nodes(stage):
    tree = stage.play(stage.pick(), ticks=3)
    kinds = set()

    def walk(node):
        kinds.add(node.kind)
        for child in node.children:
            walk(child)

    walk(tree.snapshot(0.0).root)
    assert kinds == {"decorator", "sequence", "selector", "leaf"}


@pytest.mark.requirement("S9")
def test_a_change_of_status_is_told_once(stage, probe_leaf):
    tree = TaskTree(TASK, probe_leaf("probe", stage.toolbox, RUNNING, RUNNING, DONE), stage.toolbox)
    for _ in range(3):
        tree.tick()

    changes = [event.status for event in stage.events if isinstance(event, NodeChanged)]
    assert changes == ["running", "success"]


def test_a_tree_leaves_nothing_behind(stage):
    before = len(Blackboard.storage), len(Blackboard.metadata), len(Blackboard.clients)

    stage.play(stage.pick())

    assert (len(Blackboard.storage), len(Blackboard.metadata), len(Blackboard.clients)) == before


def test_two_trees_at_once_do_not_share_their_ports(stage, stage_with):
    one = stage.pick()
    stage.play(one, ticks=20)
    other = stage.pick()

    assert stage.play(one).status == "success"
    assert other.status == "running"


def test_what_a_failed_task_never_touched_is_not_what_was_acted_on_before(stage):
    stage.told.last_acted_on = "blue box"
    tree = stage.pick()
    stage.when("plan pick", lambda: tree.halt("enough"))

    stage.play(tree)

    assert tree.status == "failure"
    assert (tree.acted_on, stage.told.last_acted_on) == ("red cup", "blue box")


def test_what_a_failed_task_had_in_a_hand_is_what_was_acted_on_before(stage):
    tree = stage.pick()
    stage.when("lift", lambda: tree.halt("enough"), after_ticks=1)

    stage.play(tree)

    assert tree.status == "failure"
    assert stage.told.last_acted_on == "red cup"


def test_a_tree_tells_what_it_was_about(stage):
    tree = stage.play(stage.pick())

    assert tree.status == "success"
    assert tree.acted_on == "red cup" == stage.told.last_acted_on
    assert tree.others == ()
