"""The doctor looks for all that the product says it runs on."""

import importlib.metadata
import tomllib
from pathlib import Path

from executive.checks import machine as diagnosis
from executive.checks.machine import diagnose, needed_packages

PROJECT = tomllib.loads((Path(__file__).parents[3] / "pyproject.toml").read_text("utf-8"))["project"]


def test_every_dependency_is_looked_for():
    needed = needed_packages(PROJECT["dependencies"])

    assert len(needed) == len(PROJECT["dependencies"])
    assert {name for name, _ in needed} <= {finding.name for finding in diagnose()}


def test_extras_are_not_needed():
    assert needed_packages(["numpy>=2.1", 'ruff; extra == "dev"']) == (("numpy", "numpy>=2.1"),)


def test_a_dependency_that_is_not_installed_is_missing(monkeypatch):
    monkeypatch.setattr(importlib.metadata, "requires", lambda _name: ["no-such-thing>=2"])

    [missing] = [finding for finding in diagnose() if not finding.ok and finding.needed]

    assert (missing.name, missing.detail) == ("no-such-thing", "not installed")
    assert missing.fix == 'pip install "no-such-thing>=2"'


def test_a_dependency_whose_module_is_gone_is_missing(monkeypatch):
    monkeypatch.setattr(importlib.metadata, "requires", lambda _name: ["lark>=1.2"])
    monkeypatch.setattr(diagnosis.importlib.util, "find_spec", lambda _name: None)

    [lark] = [finding for finding in diagnose() if finding.name == "lark"]

    assert "the module lark is gone" in lark.detail
