"""What has to be done before a task stands in the records of skills: who prepares names no skill's task."""

from __future__ import annotations

import ast

import pytest
from source import Module, modules, parse

from trees.skill import After
from trees.skills import built_in

PREPARE = (
    "executive.errands",
    "executive.session",
    "executive.scripts",
    "executive.embedding",
    "executive.runs",
)
"""Rooms of the executive that carry out what was said; others understand it, or word it."""

OWNERS = {skill.task.__name__: skill.tree.__module__ for skill in built_in().values()}
"""The folder of each skill by its task type."""


def named_for_preparing(module: Module) -> list[str]:
    """Tasks of other skills that a module makes, or branches on.

    Args:
        module: Any of trees or of the executive.
    """
    return [
        f"{module.file}:{line}: {name} is the concern of {OWNERS[name]}; records tell what comes first"
        for line, name in sorted({*_branched_on(module.tree), *_made(module.tree)})
        if name in OWNERS and not module.name.startswith(OWNERS[name])
    ]


def prepares(module: Module) -> bool:
    """Whether it carries out, or prepares, what was said: all of trees but what grounds words."""
    if module.package == "trees":
        return not module.name.startswith("trees.beliefs.")
    return module.name.startswith(PREPARE)


def _branched_on(tree: ast.AST) -> list[tuple[int, str]]:
    found = []
    for node in ast.walk(tree):
        tested: list[ast.AST] = []
        if isinstance(node, ast.Call) and ast.unparse(node.func) in ("isinstance", "issubclass"):
            tested = [node.args[1]]
        elif isinstance(node, ast.MatchClass):
            tested = [node.cls]
        elif isinstance(node, ast.Compare) and "type(" in ast.unparse(node):
            tested = [node.left, *node.comparators]
        found += [
            (node.lineno, one.id) for part in tested for one in ast.walk(part) if isinstance(one, ast.Name)
        ]
    return found


def _made(tree: ast.AST) -> list[tuple[int, str]]:
    calls = [node for node in ast.walk(tree) if isinstance(node, ast.Call)]
    return [(node.lineno, node.func.id) for node in calls if isinstance(node.func, ast.Name)]


@pytest.mark.parametrize(
    "source",
    [
        "def f(command):\n    return isinstance(command, PlaceTask)",
        "def f(command):\n    return isinstance(command, PlaceTask | PutInTask) and command.to",
        "def f(command):\n    match command:\n        case WalkToTask(to=there):\n            return there",
        "def f(command):\n    return type(command) is OpenTask",
        "def f(thing):\n    return PickTask('pick it up', thing)",
    ],
)
def test_a_task_of_a_skill_that_is_named_to_prepare_for_it_is_found(source):
    assert named_for_preparing(parse(source, "executive/errands/example.py"))


@pytest.mark.parametrize(
    ("source", "file"),
    [
        ("def f(task):\n    return isinstance(task, OpenTask)", "trees/skills/doors/example.py"),
        (
            "def f(task):\n    return Before.THING_HELD in skill_of(task).before",
            "executive/errands/example.py",
        ),
        ("def f(thing):\n    return task_that(After.THING_HELD, 'it', object=thing)", "trees/example.py"),
    ],
)
def test_a_skill_may_name_its_own_task_and_others_ask_its_record(source, file):
    assert not named_for_preparing(parse(source, file))


def test_who_prepares_asks_the_records_of_skills():
    assert not [named for module in modules() if prepares(module) for named in named_for_preparing(module)]


def test_whatever_another_skill_may_need_first_is_brought_about_by_one_skill():
    for wanted in After:
        assert len([skill.action for skill in built_in().values() if wanted in skill.after]) == 1, wanted
