"""A package from outside: the very one of the documentation, found, loaded and run."""

import re
import sys
import types
from dataclasses import dataclass
from importlib.metadata import EntryPoint
from pathlib import Path

import pytest

from trees.btcpp.outside_leaves import load_leaves
from trees.extensions import SkillExtension, extensions, load

ROOT = Path(__file__).parents[2]
GUIDE = (ROOT / "docs" / "extend" / "a-skill.md").read_text("utf-8")
_PROJECT, _WORDS, CODE = re.findall(r"```(?:python|toml)\n(.*?)```", GUIDE, re.DOTALL)


@pytest.fixture
def bowing(monkeypatch):
    """The module of the guide, as if it were installed."""
    module = types.ModuleType("bowing_bow")
    monkeypatch.setitem(sys.modules, "bowing_bow", module)
    exec(compile(CODE, "bow.py", "exec"), module.__dict__)
    return module


def test_the_guide_is_short():
    assert len(GUIDE.splitlines()) < 80


def test_the_guides_skill_runs(stage, bowing):
    from trees.task_tree import TaskTree

    tree = TaskTree(bowing.BowTask("bow"), bowing.bow(stage.toolbox), stage.toolbox)

    stage.play(tree)

    assert tree.status == "success"
    assert len(stage.fake.motion.started) == 2


def test_what_cannot_be_loaded_is_left_out_and_told(bowing):
    points = [
        EntryPoint("good", "bowing_bow:BOW", "humanoid_executive.skills"),
        EntryPoint("missing", "no_such_module:X", "humanoid_executive.skills"),
        EntryPoint("odd", "os:path", "humanoid_executive.skills"),
        EntryPoint("same", "bowing_bow:BOW", "humanoid_executive.skills"),
    ]

    found = load(points)

    assert list(found.skills) == ["bow"]
    assert len(found.complaints) == 3
    assert any("no_such_module" in line for line in found.complaints)


def test_a_leaf_that_is_none_is_left_out_and_told(bowing):
    points = [
        EntryPoint("lean", "bowing_bow:LeanForward", "humanoid_executive.leaves"),
        EntryPoint("task", "bowing_bow:BowTask", "humanoid_executive.leaves"),
        EntryPoint("twice", "bowing_bow:LeanForward", "humanoid_executive.leaves"),
        EntryPoint("gone", "bowing_bow:Nothing", "humanoid_executive.leaves"),
    ]

    found = load_leaves(points)

    assert found.leaves == (bowing.LeanForward,)
    assert len(found.complaints) == 3


def test_a_phrase_is_matched_whole_and_makes_the_task(bowing):
    found = load([EntryPoint("bow", "bowing_bow:BOW", "humanoid_executive.skills")])

    assert found.for_phrase("  Take a  BOW. ").action == "bow"
    assert found.for_phrase("take a bow and the cup") is None


def test_nothing_is_installed_here():
    assert not extensions().skills

    @dataclass(frozen=True)
    class Other:
        text: str
        action = "other"

    assert extensions().for_task(Other("x")) is None
    assert SkillExtension(Other, lambda toolbox: None, "other").phrases == ()
