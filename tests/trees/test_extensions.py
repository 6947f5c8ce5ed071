"""A skill of another package: the very one of the documentation, found, understood, built and run."""

import os
import re
import subprocess
import sys
import types
from dataclasses import dataclass
from importlib.metadata import EntryPoint
from pathlib import Path

import pytest

from trees.extensions import SkillExtension, extensions, load

ROOT = Path(__file__).parents[2]
GUIDE = (ROOT / "docs" / "how-to-add-a-skill.md").read_text("utf-8")
CODE, TOML = re.findall(r"```(?:python|toml)\n(.*?)```", GUIDE, re.DOTALL)


@pytest.fixture
def bowing(monkeypatch):
    """The module of the guide, as if it were installed."""
    module = types.ModuleType("bowing_bow")
    monkeypatch.setitem(sys.modules, "bowing_bow", module)
    exec(compile(CODE, "bow.py", "exec"), module.__dict__)
    return module


@pytest.fixture
def installed(tmp_path):
    """A folder that holds the guide's package with its metadata."""
    package, info = tmp_path / "bowing", tmp_path / "bowing-1.0.dist-info"
    package.mkdir()
    info.mkdir()
    (package / "__init__.py").write_text("")
    (package / "bow.py").write_text(CODE)
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: bowing\nVersion: 1.0\n")
    points = re.search(r'\[project.entry-points."(.*?)"\]\n(.*)', TOML, re.DOTALL)
    (info / "entry_points.txt").write_text(f"[{points[1]}]\n{points[2]}".replace('"', ""))
    return tmp_path


def test_the_guide_is_short():
    assert len(GUIDE.splitlines()) < 80


def test_an_installed_package_is_listed_understood_and_drawn(installed):
    path = os.pathsep.join([str(installed), str(ROOT)])
    script = (
        "import json; from executive.command_parser import parse; from executive.commands.list_ import *;"
        "from executive.tree_preview import preview; from executive.commands import list_ as shown;"
        "print(list(shown._lines(What.SKILLS))); parsed = parse('Take a bow!');"
        "print(json.dumps(parsed.to_json())); print(preview(parsed.commands[0]).root.name)"
    )

    done = subprocess.run(
        [sys.executable, "-c", script],
        env={**os.environ, "PYTHONPATH": path},
        capture_output=True,
        text=True,
        check=True,
    )

    listed, parsed, root = done.stdout.splitlines()
    assert "bow        take a bow" in listed
    assert '"action": "bow"' in parsed
    assert root == "bow"


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
