import pytest
from py_trees import ports

from trees.nodes.contract import Contract
from trees.nodes.leaf import Leaf
from trees.nodes.py_trees_patch import ask_once


def test_a_class_is_looked_through_once_for_all_its_instances(stage, probe_leaf):
    asked = ports._ports_class_is_abstract
    probe_leaf("first", stage.toolbox)
    before = asked.cache_info()

    probe_leaf("second", stage.toolbox)

    assert asked.cache_info().misses == before.misses
    assert asked.cache_info().hits == before.hits + 1


def test_asking_twice_to_ask_once_changes_nothing():
    asked = ports._ports_class_is_abstract

    ask_once()

    assert ports._ports_class_is_abstract is asked


def test_a_leaf_without_ports_is_refused_all_the_same(stage):
    class Portless(Leaf):
        CONTRACT = Contract("none", "none", deadline_s=1.0)

    for _ in range(2):
        with pytest.raises(TypeError, match="abstract class Portless"):
            Portless("portless", stage.toolbox)
