"""What every leaf must declare, found by looking at all of them."""

import importlib
import inspect
import pkgutil
import subprocess
import sys

import pytest

import trees.leaves
from trees.contract import Contract
from trees.job_leaf import JobLeaf
from trees.leaf import Leaf
from trees.motion_leaf import MotionLeaf
from trees.planned_motion_leaf import PlannedMotionLeaf

LEAVES = sorted(
    {
        item
        for module in pkgutil.iter_modules(trees.leaves.__path__)
        for _, item in inspect.getmembers(
            importlib.import_module(f"trees.leaves.{module.name}"), inspect.isclass
        )
        if issubclass(item, Leaf) and item.__module__.startswith("trees.leaves")
    },
    key=lambda item: item.__name__,
)


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
def test_a_leaf_declares_what_it_reads_and_writes(leaf):
    source = inspect.getsource(leaf)

    for port in leaf.INPUT_PORTS:
        if "get_input" in source or "optional(" in source:
            assert any(
                f'"{port}"' in inspect.getsource(owner) for owner in leaf.__mro__ if issubclass(owner, Leaf)
            )
    for port in leaf.OUTPUT_PORTS:
        assert f'"{port}"' in source or f"{port}=" in source


@pytest.mark.parametrize("leaf", LEAVES, ids=lambda leaf: leaf.__name__)
def test_a_leaf_that_moves_something_stops_it_when_it_is_released(leaf):
    moves = issubclass(leaf, MotionLeaf | PlannedMotionLeaf)

    assert (leaf.CONTRACT.moves != "nothing") == moves
    if moves or issubclass(leaf, JobLeaf):
        assert leaf.release is not Leaf.release


@pytest.mark.requirement("U2")
def test_behaviors_and_the_fake_robot_need_no_simulator():
    script = (
        "import sys; import trees.build, robots.fake.fake_world;"
        "sys.exit(any(name.split('.')[0] == 'mujoco' for name in sys.modules))"
    )

    assert subprocess.run([sys.executable, "-c", script], check=False).returncode == 0
