"""What belongs together goes about as one value, and an answer has its request's type."""

from __future__ import annotations

import ast
import re
from collections import Counter
from collections.abc import Iterator

import pytest
from source import Module, modules, parse

MOST_PAIRS = 5
# Who asks planners and the checker, and who answers.
DOORS = (
    "kinematics.motion_planner", "kinematics.planning", "trees", "executive.session", "executive.live",
    "robots.fake",
)  # fmt: skip
_STANCE = re.compile(r"\bStance\b")
_ANSWERS = re.compile(r"(Request|Plan|CheckedTrajectory|Unsafe)\b")
_CACHES = ("lru_cache", "cache")
_ROBOTS = re.compile(r"\b(RobotModel|Stance|StandingRobot|RobotBuild)\b")


def _annotations(node: ast.AST) -> Iterator[tuple[str, str]]:
    """Names and types of a function's parameters, or of a class's fields."""
    if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda):
        for arg in (*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs):
            yield arg.arg, "" if arg.annotation is None else ast.unparse(arg.annotation)
    elif isinstance(node, ast.ClassDef):
        for field in node.body:
            if isinstance(field, ast.AnnAssign):
                yield ast.unparse(field.target), ast.unparse(field.annotation)


def pairs(module: Module) -> list[str]:
    """Signatures and values that take a model and a stance side by side."""
    found = []
    for node in ast.walk(module.tree):
        taken = dict(_annotations(node))
        by_type = any("RobotModel" in kind for kind in taken.values()) and any(
            _STANCE.search(kind) for kind in taken.values()
        )
        if {"model", "stance"} <= set(taken) or by_type:
            found.append(f"{module.file}:{node.lineno}: takes a model and a stance, not a StandingRobot")
    return found


def tables(module: Module) -> list[str]:
    """Functions that remember by robot in a table of their module: robots keep what is derived of them."""
    return [
        f"{module.file}:{node.lineno}: {node.name} remembers by robot; let the robot keep it, see Derivable"
        for node in ast.walk(module.tree)
        if isinstance(node, ast.FunctionDef)
        and any(any(word in ast.unparse(item) for word in _CACHES) for item in node.decorator_list)
        and any(_ROBOTS.search(kind) for _, kind in _annotations(node))
    ]


def untyped_answers(module: Module) -> list[str]:
    """Answers, plans and verdicts of any type: a request and a job know what they are answered by."""
    return [
        f"{module.file}:{getattr(node, 'lineno', 0)}: {name} has no type"
        for node in ast.walk(module.tree)
        for name, kind in (*_annotations(node), *_assigned(node))
        if name in ("answer", "plan", "verdict") and kind == "Any"
    ]


def _assigned(node: ast.AST) -> Iterator[tuple[str, str]]:
    if isinstance(node, ast.AnnAssign):
        yield ast.unparse(node.target), ast.unparse(node.annotation)


def ladders(module: Module) -> list[str]:
    """Functions that ask more than once what kind of request or answer something is."""
    found = []
    for function in ast.walk(module.tree):
        if isinstance(function, ast.FunctionDef):
            asked = Counter(
                ast.unparse(node.args[0])
                for node in ast.walk(function)
                if isinstance(node, ast.Call)
                and ast.unparse(node.func) == "isinstance"
                and _ANSWERS.search(ast.unparse(node.args[1]))
            )
            found += [
                f"{module.file}:{function.lineno}: {function.name} asks {times} times what {name} is"
                for name, times in asked.items()
                if times > 1
            ]
    return found


BREACHES = [
    (pairs, "def f(model: RobotModel, stance: Stance) -> None: ..."),
    (pairs, "def f(model, q, *, stance): ..."),
    (pairs, "class A:\n    body: RobotModel\n    feet: Stance | None"),
    (untyped_answers, "def accept(self, answer: Any) -> None: ..."),
    (untyped_answers, "def f(job):\n    answer: Any = job.result()"),
    (ladders, "def f(x):\n    if isinstance(x, PickPlan): ...\n    if isinstance(x, NoPlan): ..."),
    (tables, "@functools.lru_cache(maxsize=4)\ndef f(model: RobotModel) -> int: ..."),
    (tables, "@functools.cache\ndef f(robot: StandingRobot, hand: Hand) -> int: ..."),
]


@pytest.mark.parametrize(("rule", "source"), BREACHES)
def test_a_rule_catches_its_breach(rule, source):
    assert rule(parse(source))


@pytest.mark.parametrize("source", ["def f(robot: StandingRobot): ...", "def f(model: RobotModel, q): ..."])
def test_one_value_is_no_pair(source):
    assert not pairs(parse(source))


def test_model_and_stance_hardly_ever_go_side_by_side():
    found = [pair for module in modules() for pair in pairs(module)]

    assert len(found) <= MOST_PAIRS, "\n".join(found)


def test_no_module_keeps_a_table_of_robots():
    found = [table for module in modules() for table in tables(module)]

    assert not found, "\n".join(found)


def test_no_answer_is_of_any_type():
    found = [answer for module in modules() for answer in untyped_answers(module)]

    assert not found, "\n".join(found)


def test_nobody_who_asks_or_answers_has_to_find_out_what_kind_of_thing_it_is():
    doors = [module for module in modules() if module.name.startswith(DOORS)]
    found = [ladder for module in doors for ladder in ladders(module)]

    assert doors
    assert not found, "\n".join(found)
