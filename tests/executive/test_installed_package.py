"""The package of the guide, built and installed by pip, as another process sees it."""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
GUIDE = (ROOT / "docs" / "extend" / "a-skill.md").read_text("utf-8")
PROJECT, WORDS, CODE = re.findall(r"```(?:python|toml)\n(.*?)```", GUIDE, re.DOTALL)[3:]


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    """A folder into which pip installed the guide's package; the environment of a process that sees it."""
    source, target = tmp_path_factory.mktemp("source"), tmp_path_factory.mktemp("target")
    (source / "bowing").mkdir()
    (source / "pyproject.toml").write_text(PROJECT)
    (source / "bowing" / "__init__.py").write_text("")
    (source / "bowing" / "theatre.toml").write_text(WORDS)
    (source / "bowing" / "bow.py").write_text(CODE)
    options = ["--quiet", "--no-deps", "--no-build-isolation", "--no-index", "--target", str(target)]
    subprocess.run([sys.executable, "-m", "pip", "install", *options, str(source)], check=True)
    return {**os.environ, "PYTHONPATH": os.pathsep.join([str(target), str(ROOT)])}


def run(environment, *arguments):
    return subprocess.run(
        [sys.executable, *arguments], env=environment, capture_output=True, text=True, cwd=ROOT, check=False
    )


def test_an_installed_package_is_listed_understood_and_drawn(installed):
    script = (
        "import json; from executive.understanding.command_parser import parse;"
        "from executive.cli.commands.list_ import *;"
        "from executive.checks.tree_preview import preview, preview_document, preview_of_document;"
        "from executive.cli.commands import list_ as shown;"
        "print(list(shown._lines(What.SKILLS))); parsed = parse('Take a bow!');"
        "print(json.dumps(parsed.to_json())); print(preview(parsed.commands[0]).root.name);"
        "document = preview_document(parsed.commands[0]);"
        "print(preview_of_document(document, 'bow.xml').root == preview(parsed.commands[0]).root);"
        "print(json.dumps(parse('pick up the bunch of flowers').to_json()))"
    )

    done = run(installed, "-c", script)

    listed, parsed, root, same, words = done.stdout.splitlines()
    assert "bow        take a bow" in listed
    assert "left out" not in listed
    assert '"action": "bow"' in parsed
    assert root == "bow"
    assert same == "True"
    assert json.loads(words)["tasks"] == [{"action": "pick", "object": {"kind": "bouquet"}}]


def test_the_leaf_of_an_installed_package_is_held_to_the_contract(installed):
    contract = "tests/trees/test_leaf_contract.py"

    done = run(
        installed, "-m", "pytest", "-q", "-n0", "-p", "no:cacheprovider", contract, "-k", "LeanForward"
    )

    assert done.returncode == 0, done.stdout[-2000:]
    assert int(re.search(r"(\d+) passed", done.stdout)[1]) >= 7


def test_nothing_of_other_packages_is_loaded_before_it_is_asked_for(installed):
    script = (
        "import sys, executive.cli.app, trees.extensions, robots.scenes.scene_file;"
        "print('bowing' in sys.modules);"
        "from executive.understanding.command_parser import parse; parse('go home');"
        "print('bowing.bow' in sys.modules)"
    )

    assert run(installed, "-c", script).stdout.split() == ["False", "False"]
