"""Trees read from documents run as BehaviorTree.CPP runs them, tick by tick, on 500 random trees.

What BehaviorTree.CPP 4 itself did is recorded in ``btcpp_traces.json`` by ``python -m tools.control_flow``;
where its Python wheel is installed, the record is held against it again.
"""

import importlib.util
import json
from pathlib import Path

import pytest

from tools.control_flow.random_trees import document, random_tree
from tools.control_flow.referee import WHEEL, referee_trace
from tools.control_flow.trace import Trace
from trees.btcpp import catalogue
from trees.btcpp.leaf_kinds import leaf_kind
from trees.btcpp.reader import read_tree
from trees.failures import Failure, FailureKind
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, RUNNING, Leaf
from trees.nodes.ports import ports

RECORD = json.loads((Path(__file__).parent / "btcpp_traces.json").read_text("utf-8"))
OUTCOMES = {"R": RUNNING, "S": DONE, "F": Failure.error("as its script says")}


class Scripted(Leaf, register=False):
    """Answers by the script of its number; the trace is put on the class for one tree at a time."""

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()
    CONTRACT = Contract("none", "none", deadline_s=1e9)
    trace: Trace

    def __init__(self, name, toolbox, number: int):
        super().__init__(name, toolbox)
        self.number, self.started = number, False

    def begin(self):
        self.started = True

    def step(self):
        started, self.started = self.started, False
        return OUTCOMES[self.trace.answer(self.number, started)]

    def release(self, reason):
        if self.failure.kind is FailureKind.CANCELED:
            self.trace.halted(self.number)


@pytest.fixture
def run_here(monkeypatch, stage):
    kinds = {**catalogue.kinds_by_id(), "Scripted": leaf_kind(Scripted)}
    monkeypatch.setattr(catalogue, "kinds_by_id", lambda: kinds)

    def run(tree):
        Scripted.trace = Trace(tree)
        text = document(tree, lambda leaf: f'<Scripted number="{leaf.number}"/>')
        root = read_tree(text, stage.toolbox)

        def tick():
            root.tick_once()
            return root.status.name[0]

        return "|".join(Scripted.trace.run(tick))

    return run


@pytest.mark.parametrize("first", range(0, 500, 50))
def test_random_trees_run_as_btcpp_runs_them(run_here, first):
    for seed in range(first, first + 50):
        assert run_here(random_tree(seed)) == RECORD[seed], f"seed {seed}"


def test_the_random_trees_have_every_kind_of_node_many_times():
    def kinds(node):
        yield node.kind
        for child in node.children:
            yield from kinds(child)

    found = [kind for seed in range(500) for kind in kinds(random_tree(seed)) if kind]

    assert len(set(found)) == 15
    assert min(found.count(kind) for kind in set(found)) >= 100


@pytest.mark.skipif(importlib.util.find_spec(WHEEL) is None, reason=f"{WHEEL} is not installed")
def test_the_record_is_what_btcpp_does():
    for seed in range(500):
        assert "|".join(referee_trace(random_tree(seed))) == RECORD[seed], f"seed {seed}"
