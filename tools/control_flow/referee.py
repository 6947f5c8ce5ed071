"""BehaviorTree.CPP itself, in its Python wheel ``behaviortreepy``, as a referee of control flow."""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from typing import Any

from tools.control_flow.random_trees import RandomNode, document
from tools.control_flow.trace import Trace

WHEEL = "behaviortreepy"


def referee_trace(tree: RandomNode) -> list[str]:
    """What BehaviorTree.CPP does with a tree.

    Raises:
        ModuleNotFoundError: The wheel is not installed: ``pip install behaviortreepy``.
    """
    engine: Any = importlib.import_module(WHEEL)
    statuses = {
        "R": engine.NodeStatus.RUNNING,
        "S": engine.NodeStatus.SUCCESS,
        "F": engine.NodeStatus.FAILURE,
    }
    trace, factory = Trace(tree), engine.BehaviorTreeFactory()
    for leaf in tree.leaves():
        _register(factory, leaf, trace, statuses)
    made = factory.create_tree_from_text(document(tree, lambda leaf: f"<Leaf{leaf.number}/>"))
    return trace.run(lambda: str(made.tick_exactly_once().name)[0])


def _register(factory: Any, leaf: RandomNode, trace: Trace, statuses: Mapping[str, Any]) -> None:
    number = leaf.number
    if leaf.condition:
        factory.register_simple_condition(f"Leaf{number}", lambda _node: statuses[trace.answer(number, True)])
        return
    factory.register_simple_stateful_action(
        f"Leaf{number}",
        lambda _node: statuses[trace.answer(number, True)],
        lambda _node: statuses[trace.answer(number, False)],
        lambda _node: trace.halted(number),
    )
