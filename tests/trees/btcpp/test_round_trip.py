"""Trees are written as documents and read back: the same nodes, the same wiring, the same behavior."""

import functools
from xml.etree import ElementTree

import pytest
from py_trees.blackboard import Blackboard

from executive.session.events import plain
from tests.trees.example_tasks import TASKS, root_of
from trees.btcpp.reader import read_tree
from trees.btcpp.writer import write_tree
from trees.nodes.leaf import Leaf
from trees.nodes.snapshot_of import snapshot_of
from trees.task_tree import TaskTree
from trees.tasks import ObjectDescription, PickTask, PlaceTask, WaveTask

RED_CUP = ObjectDescription("cup", "red")


@pytest.fixture(params=TASKS.values(), ids=lambda task: task.action)
def skill(request):
    return functools.partial(root_of, request.param)


def described(node):
    """All that a node is, but for its identity."""
    own = {name: getattr(node, name, None) for name in ("settings", "wiring", "transparent", "memory")}
    judged = ("hopeless", "worth_trying", "worth_it", "limit", "kinds", "deadline_s")
    return (type(node).__name__, node.name, own, {name: getattr(node, name, None) for name in judged})


def wired(leaf):
    return {port: leaf.wiring.get(port, port) for port in (*leaf.INPUT_PORTS, *leaf.OUTPUT_PORTS)}


def test_every_skill_is_read_back_as_it_was_written(skill, stage):
    tree = skill(stage.toolbox)
    text = write_tree(tree)

    again = read_tree(text, stage.toolbox)

    assert write_tree(again) == text
    assert snapshot_of(again) == snapshot_of(tree)
    for one, other in zip(tree.iterate(), again.iterate(), strict=True):
        if isinstance(one, Leaf):
            assert type(one) is type(other)
            assert (one.name, dict(one.settings)) == (other.name, dict(other.settings))
            assert wired(one) == wired(other)
        else:
            assert getattr(one, "transparent", False) == getattr(other, "transparent", False)
            assert described(one)[3] == described(other)[3]


def slips(stage):
    stage.when("verify lift", lambda: stage.fake.world.remove("red cup"))


def hits(stage):
    stage.fake.planning.motion_s = 0.08  # so that the touch is felt on the way
    stage.when("lower", lambda: stage.fake.pull_n.update(right=(0.0, 0.0, 60.0)), 3)
    stage.when("lift it again", stage.fake.pull_n.clear)


@pytest.mark.parametrize(
    ("task", "upset"),
    [
        (PickTask("pick up the red cup", RED_CUP), lambda stage: None),
        (PickTask("pick up the red cup", RED_CUP), slips),
        (PlaceTask("put the red cup on the table", RED_CUP, on="table"), hits),
        (WaveTask("wave at Ana", "Ana"), lambda stage: None),
    ],
    ids=["pick", "pick that slips", "place that is blocked", "wave at nobody"],
)
def test_a_tree_that_was_read_back_does_the_same_to_the_last_event(new_stage, task, upset):
    def run(prepare):
        stage = new_stage()
        upset(stage)
        root = prepare(root_of(task, stage.toolbox), stage.toolbox)
        tree = stage.play(TaskTree(task, root, stage.toolbox))
        Blackboard.clear()
        return tree.status, tree.evidence, tree.failure, [plain(event) for event in stage.events]

    built = run(lambda root, _toolbox: root)
    read = run(lambda root, toolbox: read_tree(write_tree(root), toolbox))

    assert len(built[3]) > 3
    assert read == built


def test_the_document_has_a_model_of_every_node_that_is_not_builtin(skill, stage):
    document = ElementTree.fromstring(write_tree(skill(stage.toolbox)))
    (tree,) = document.findall("BehaviorTree")
    builtin = {"Sequence", "Fallback"}
    used = {node.tag for node in tree.iter()} - {"BehaviorTree"} - builtin

    models = {model.get("ID"): model for model in document.find("TreeNodesModel")}

    assert document.get("BTCPP_format") == "4"
    assert document.get("main_tree_to_execute") == tree.get("ID")
    assert set(models) == used
    for node in tree.iter():
        if node.tag in models:
            ports = {port.get("name") for port in models[node.tag] if port.tag.endswith("_port")}
            written = {name for name in node.attrib if name != "name" and not name.startswith("_")}
            assert written <= ports, node.tag
    assert all(model.find("MetadataFields/Metadata").get("description") for model in models.values())


def test_ports_have_direction_type_and_description(stage):
    document = ElementTree.fromstring(write_tree(root_of(TASKS[PickTask], stage.toolbox)))
    model = document.find("TreeNodesModel/Action[@ID='CheckTrajectory']")

    assert model.find("input_port[@name='step']").get("type") == "Step"
    assert model.find("output_port[@name='checked']").get("type") == "CheckedStep"
    assert model.find("input_port[@name='tried']") is None
    retry = document.find("TreeNodesModel/Control[@ID='Retry']/output_port[@name='failure']")
    assert retry.text == "why the attempt failed"
