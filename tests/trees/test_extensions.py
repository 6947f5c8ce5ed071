"""A package from outside: the very one of the documentation, found, loaded and run."""

import re
import sys
import types
from importlib.metadata import EntryPoint
from pathlib import Path

import pytest

from trees.btcpp.outside_leaves import load_leaves
from trees.extensions import extensions, load
from trees.skill import Skill
from trees.skills import built_in

ROOT = Path(__file__).parents[2]
GUIDE = (ROOT / "docs" / "extend" / "a-skill.md").read_text("utf-8")
_PROJECT, _WORDS, CODE = re.findall(r"```(?:python|toml)\n(.*?)```", GUIDE, re.DOTALL)[3:]


@pytest.fixture
def bowing(monkeypatch):
    """The module of the guide, as if it were installed."""
    module = types.ModuleType("bowing_bow")
    monkeypatch.setitem(sys.modules, "bowing_bow", module)
    exec(compile(CODE, "bow.py", "exec"), module.__dict__)
    return module


def test_the_guide_is_short():
    assert len(GUIDE.splitlines()) < 200


def test_the_guides_skill_runs(stage, bowing):
    from trees.task_tree import TaskTree

    tree = TaskTree(
        bowing.BowTask("bow"), bowing.BOW.tree(bowing.BowTask("bow"), stage.toolbox), stage.toolbox
    )

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


def test_an_installed_skill_does_not_take_the_place_of_one_of_the_robots_own(monkeypatch):
    record = types.ModuleType("greedy")
    record.PICK = built_in()["pick"]
    monkeypatch.setitem(sys.modules, "greedy", record)

    found = load([EntryPoint("pick", "greedy:PICK", "humanoid_executive.skills")], built_in())

    assert not found.skills
    assert found.complaints == ("skill 'pick': there is a skill 'pick' already",)


def test_a_record_whose_task_is_none_is_left_out_and_told(monkeypatch):
    record = types.ModuleType("taskless")
    record.ODD = Skill(task=str, tree=lambda task, toolbox: None, example="odd")
    monkeypatch.setitem(sys.modules, "taskless", record)

    found = load([EntryPoint("odd", "taskless:ODD", "humanoid_executive.skills")])

    assert found.complaints == ("skill 'odd' is no Skill whose task has a text and an action",)


def test_the_guides_skill_imports_one_module_of_the_project():
    imported = re.findall(r"^(?:from|import) (\S+)", CODE, re.MULTILINE)

    assert set(imported) == {"dataclasses", "trees.api"}


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
