"""Groot2's side of a served robot: its tree, and its statuses, at a port of this machine."""

import struct
import threading
from xml.etree import ElementTree

import behaviortreepy
import pytest
import zmq

from executive.checks.tree_preview import preview_document
from executive.doors.groot.groot_process import GrootPortTakenError, Monitor
from executive.doors.groot.monitored_tree import MonitoredTree
from executive.understanding.command_parser import parse
from kinematics.whole_file import write_whole
from trees.snapshot import NodeSnapshot, TreeSnapshot

DOCUMENT = """<root BTCPP_format="4"><BehaviorTree ID="Wave"><Sequence name="wave"><RaiseHand name="raise"/>
</Sequence></BehaviorTree></root>"""
_PORT = iter(range(17300, 17400, 2))


def snapshot(status):
    leaf = NodeSnapshot("raise", "leaf", status, "0.1 m")
    return TreeSnapshot(1.0, 1, NodeSnapshot("wave", "sequence", "running", "", (leaf,)))


def ask(port, letter, *more):
    context = zmq.Context()
    socket = context.socket(zmq.REQ)
    socket.connect(f"tcp://127.0.0.1:{port}")
    socket.send_multipart([struct.pack("<BcI", 2, letter, 1), *more])
    assert socket.poll(10_000)
    told = socket.recv_multipart()
    context.destroy(0)
    return told


@pytest.fixture
def port(served, tmp_path):
    write_whole(tmp_path / "tree.xml", DOCUMENT.encode())
    served.trees.written = lambda: {"number": 4, "path": str(tmp_path / "tree.xml")}
    number, over = next(_PORT), threading.Event()
    monitor = Monitor(served.folder.path, number)
    thread = threading.Thread(target=monitor.run, args=(over.is_set,))
    thread.start()
    yield number
    over.set()
    thread.join()
    monitor.close()


def until(so):
    for _ in range(400):
        if so():
            return
        threading.Event().wait(0.025)
    raise AssertionError


@pytest.mark.requirement("U6")
def test_the_tree_and_its_statuses_are_those_of_the_served_robot(served, port):
    until(lambda: served.watched)
    served.show(lambda watchers: watchers.tree(lambda: snapshot("running"), 1.0, number=4))
    until(lambda: ask(port, b"S")[1] == b"\x01\x00\x01\x02\x00\x01")

    tree = ElementTree.fromstring(ask(port, b"T")[1].decode())
    assert [one.get("_uid") for one in tree.find("BehaviorTree").iter()][1:] == ["1", "2"]
    served.show(lambda watchers: watchers.tree(lambda: snapshot("idle"), 2.0, number=4))
    until(lambda: ask(port, b"S")[1] == b"\x01\x00\x01\x02\x00\x0b")


def test_before_there_is_a_tree_none_is_told(port):
    assert ask(port, b"S")[1] == b""


def test_a_taken_port_is_said(served, port):
    with pytest.raises(GrootPortTakenError, match=f"port {port} or {port + 1}"):
        Monitor(served.folder.path, port)


@pytest.mark.parametrize("text", ["pick up the red cup on the table", "open the fridge"])
def test_the_real_library_loads_the_tree_with_its_model(text):
    """It knows nodes by their kind alone here: ports of such nodes, and controls, cannot be taught to it."""
    (command,) = parse(text).commands
    document = MonitoredTree(preview_document(command)).xml
    root = ElementTree.fromstring(document)
    model = {one.get("ID"): one.tag for one in root.find("TreeNodesModel")}
    factory = behaviortreepy.BehaviorTreeFactory()
    success = behaviortreepy.NodeStatus.SUCCESS
    for name, kind in model.items():
        if kind == "Decorator":
            factory.register_simple_decorator(name, lambda _node, _status: success)
        elif kind == "Condition":
            factory.register_simple_condition(name, lambda _node: success)
        elif kind == "Action":
            factory.register_simple_action(name, lambda _node: success)
    nodes = 0
    for node in root.find("BehaviorTree")[0].iter():
        nodes += 1
        if model.get(node.tag) == "Control":
            node.tag = "Sequence"
        for port in set(node.attrib) - {"name", "_uid"}:
            del node.attrib[port]
    factory.register_behavior_tree_from_text(ElementTree.tostring(root, encoding="unicode"))

    tree = factory.create_tree(root.find("BehaviorTree").get("ID"))
    assert tree.tick_exactly_once() == success
    number = next(_PORT)
    publisher = behaviortreepy.Groot2Publisher(tree, number)
    assert len(ask(number, b"S")[1]) == 3 * nodes
    del publisher
