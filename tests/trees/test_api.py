"""What a skill's author imports: every name is there, typed and loaded late."""

import ast
import importlib
import subprocess
import sys
from pathlib import Path

import pytest

from trees import api

SOURCE = Path(api.__file__).read_text("utf-8")


@pytest.mark.parametrize("name", api.__all__)
def test_every_name_is_that_of_the_module_that_it_is_from(name):
    assert getattr(api, name) is getattr(importlib.import_module(api._FROM[name]), name)


def test_what_is_typed_is_what_is_loaded():
    typed = {
        alias.name: node.module
        for block in ast.parse(SOURCE).body
        if isinstance(block, ast.If)
        for node in block.body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }

    assert typed == dict(api._FROM)
    assert sorted(typed) == sorted(api.__all__)


def test_a_name_that_is_none_is_told_with_those_that_are():
    with pytest.raises(AttributeError, match=r"no attribute 'Skil'; it has .*Skill"):
        _ = api.Skil


def test_a_record_is_loaded_without_what_acts():
    code = "import sys; from trees.api import Skill; print('py_trees' in sys.modules, 'numpy' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)

    assert done.stdout.split() == ["False", "False"]
