import pytest
from py_trees import ports as library
from py_trees.behaviours import Success

from trees.nodes.contract import Contract
from trees.nodes.leaf import Leaf
from trees.nodes.ports import WithPorts, ports
from trees.nodes.retry import Retry
from trees.nodes.skipping import UnlessHeld


def test_making_a_node_does_not_look_through_its_class(stage, probe_leaf, monkeypatch):
    looked_through = []
    monkeypatch.setattr(library, "_ports_class_is_abstract", looked_through.append)

    leaf = probe_leaf("leaf", stage.toolbox)
    UnlessHeld(Retry("attempts", leaf, probe_leaf("recover", stage.toolbox), 2, lambda *failures: False))

    assert looked_through == []


def test_a_node_begins_with_what_the_library_gives_a_node_with_ports():
    class Theirs(library.PortsMixin, Success, register=False):
        INPUT_PORTS = OUTPUT_PORTS = ports()

    class Ours(WithPorts, Success, register=False):
        INPUT_PORTS = OUTPUT_PORTS = ports()

    theirs, ours = vars(Theirs("node")), vars(Ours("node"))

    begins_as = {name: value for name, value in theirs.items() if value is None}
    assert begins_as
    assert {name: ours.get(name, "missing") for name in begins_as} == begins_as
    assert set(ours) == set(theirs)
    assert Ours("node").behaviour_class_name == "Ours"


def test_a_leaf_without_ports_is_refused(stage):
    class Portless(Leaf):
        CONTRACT = Contract("none", "none", deadline_s=1.0)

    for _ in range(2):
        with pytest.raises(TypeError, match=r"Portless .* INPUT_PORTS and OUTPUT_PORTS"):
            Portless("portless", stage.toolbox)


def test_the_library_is_as_it_was_made():
    assert not hasattr(library._ports_class_is_abstract, "cache_info")
