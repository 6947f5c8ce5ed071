"""What every leaf must declare, found by looking at all of them."""

import ast
import functools
import importlib
import inspect
import re
import subprocess
import sys

import pytest

from trees.btcpp.leaf_kinds import known_leaves
from trees.nodes.contract import Contract
from trees.nodes.job_leaf import JobLeaf
from trees.nodes.leaf import Leaf
from trees.nodes.motion_leaf import MotionLeaf
from trees.nodes.planned_motion_leaf import PlannedMotionLeaf
from trees.skills.walking.walking_leaf import WalkingLeaf

LEAVES = [leaf for leaf in known_leaves().values() if leaf.__module__.startswith("trees.")]


@functools.cache
def sources_in(module):
    """The sources of a module's classes and of their methods, by qualified name, from one parsing."""
    text = inspect.getsource(importlib.import_module(module))
    lines = text.splitlines(keepends=True)
    classes = [node for node in ast.parse(text).body if isinstance(node, ast.ClassDef)]
    found = {node.name: node for node in classes}
    found |= {
        f"{node.name}.{part.name}": part
        for node in classes
        for part in node.body
        if isinstance(part, ast.FunctionDef)
    }
    return {name: "".join(lines[node.lineno - 1 : node.end_lineno]) for name, node in found.items()}


def source_of(item):
    return sources_in(item.__module__)[item.__qualname__]


def own_source_of(leaf):
    """Of a leaf and all that it inherits from, but for what every leaf does."""
    return "".join(map(source_of, parts_of(leaf)))


def parts_of(leaf):
    return [part for part in leaf.__mro__ if part.__module__.startswith("trees.") and part is not Leaf]


def methods_of(leaf):
    """Those that it runs, so that a port of what it inherits and does otherwise counts for nothing."""
    names = sorted({name for part in parts_of(leaf) for name in vars(part)})
    found = [inspect.getattr_static(leaf, name) for name in names]
    return [method for item in found if inspect.isfunction(method := getattr(item, "fget", item))]


@pytest.mark.parametrize("leaf", LEAVES, ids=lambda leaf: leaf.__name__)
def test_a_leaf_declares_its_promises(leaf):
    contract = leaf.CONTRACT

    assert isinstance(contract, Contract)
    assert contract.precondition
    assert contract.postcondition
    assert contract.deadline_s > 0.0
    assert contract.on_success
    assert contract.on_failure
    assert contract.on_cancel


@pytest.mark.parametrize("leaf", LEAVES, ids=lambda leaf: leaf.__name__)
def test_a_leaf_reads_and_writes_every_port_that_it_declares(leaf):
    source = own_source_of(leaf)

    for port in leaf.INPUT_PORTS:
        assert f'get_input("{port}")' in source or f'optional("{port}")' in source
    for port in leaf.OUTPUT_PORTS:
        assert f'"{port}"' in source


@pytest.mark.parametrize("leaf", LEAVES, ids=lambda leaf: leaf.__name__)
def test_a_leaf_reads_no_port_that_it_does_not_declare(leaf):
    read = set(re.findall(r'(?:get_input|optional)\("(\w+)"\)', "".join(map(source_of, methods_of(leaf)))))

    assert read <= set(leaf.INPUT_PORTS)


@pytest.mark.parametrize("leaf", LEAVES, ids=lambda leaf: leaf.__name__)
def test_a_leaf_that_moves_something_stops_it_when_it_is_released(leaf):
    moves = issubclass(leaf, MotionLeaf | PlannedMotionLeaf | WalkingLeaf)

    assert (leaf.CONTRACT.moves != "nothing") == moves
    if moves or issubclass(leaf, JobLeaf):
        assert leaf.release is not Leaf.release


@pytest.mark.requirement("U2")
def test_behaviors_and_the_fake_robot_need_neither_a_simulator_nor_a_compiler():
    script = (
        "import sys; import trees.build, robots.fake.fake_world;"
        "sys.exit(any(name.split('.')[0] in ('mujoco', 'numba') for name in sys.modules))"
    )

    assert subprocess.run([sys.executable, "-c", script], check=False).returncode == 0
