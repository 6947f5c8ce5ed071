"""Modules that are named in guides, commands and quoted programs are where they are said to be."""

import importlib
import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
COMMAND = re.compile(r"python -m ((?:tools|executive|trees|robots|kinematics)(?:\.\w+)*)")
IMPORT = re.compile(
    r"^(?:>>> )?from ((?:tools|executive|trees|robots|kinematics)[\w.]*) import (.+)$", re.MULTILINE
)
PATH = re.compile(r"\b(?:tests|tools|executive|trees|robots|kinematics)/[\w/]+\.py\b")
SAMPLES = ("tests/architecture/", "tests/kinematics/compiled/test_cache.py", "docs/adr/", "CHANGELOG.md")
"""Their modules are made up, or are those of their day."""


def texts():
    listed = subprocess.run(
        ["git", "ls-files", "*.md", "*.py", "*.toml", "Makefile"], cwd=ROOT, capture_output=True, text=True
    )
    if listed.returncode:
        pytest.skip("not a checkout")
    for name in listed.stdout.split():
        if not name.startswith(SAMPLES) and (ROOT / name).exists():
            yield name, (ROOT / name).read_text("utf-8")


def module_exists(name):
    path = ROOT.joinpath(*name.split("."))
    return path.with_suffix(".py").exists() or path.is_dir()


def exports(module, name):
    return module_exists(f"{module}.{name}") or hasattr(importlib.import_module(module), name)


def test_every_command_that_is_written_down_names_a_module():
    wrong = [
        f"{file}: {name}"
        for file, text in texts()
        for name in COMMAND.findall(text)
        if not module_exists(name)
    ]

    assert wrong == []


def test_every_import_that_is_written_down_finds_what_it_names():
    wrong = [
        f"{file}: from {module} import {name}"
        for file, text in texts()
        for module, names in IMPORT.findall(text)
        for name in re.findall(r"(\w+)(?: as \w+)?", names.split("#")[0])
        if not module_exists(module) or not exports(module, name)
    ]

    assert wrong == []


def test_every_source_that_a_guide_names_is_there():
    wrong = [
        f"{file}: {path}"
        for file, text in texts()
        if file.endswith(".md")
        for path in PATH.findall(text)
        if not (ROOT / path).exists()
    ]

    assert wrong == []
