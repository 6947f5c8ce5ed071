"""A reader finds the thing by guessing its file name."""

import ast

from source import PRODUCT, ROOT, modules

SHAPELESS = {"utils", "util", "helpers", "helper", "common", "misc", "manager", "managers", "base", "core"}


def test_no_file_has_a_shapeless_name():
    assert not [m.file for m in modules() if m.path.stem in SHAPELESS]


def test_every_module_says_what_it_is():
    silent = [m.file for m in modules() if m.path.name != "__init__.py" and not ast.get_docstring(m.tree)]

    assert not silent


def test_every_package_ships_its_types():
    assert all((ROOT / package / "py.typed").is_file() for package in PRODUCT)


def test_no_module_does_work_when_it_is_imported():
    working = [
        f"{m.file}:{node.lineno}"
        for m in modules()
        if m.path.name != "__main__.py"
        for node in m.tree.body
        if isinstance(node, ast.For | ast.While | ast.With)
    ]

    assert not working
