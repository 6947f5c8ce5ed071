"""How a task goes on, and what it came to, as fields for messages: from the robot's status and its report."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

_QUANTITY = re.compile(r"(?<![\w.])([+-]?\d+(?:\.\d+)?)(?![\w.]) ?([^\W\d_][\w/]*|%)?")
_LONGEST_CHAIN = 20


@dataclass(frozen=True)
class Progress:
    """How a task stands.

    Attributes:
        line: The newest line for people.
        tree_path: Names of the nodes under way, from the root of the tree to the leaf.
        leaf_says: The newest that this leaf has to say.
        question: What is asked and not answered yet.
        choices: What may be answered, where that is known.
    """

    line: str = ""
    tree_path: tuple[str, ...] = ()
    leaf_says: str = ""
    question: str = ""
    choices: tuple[str, ...] = ()

    @property
    def leaf(self) -> str:
        """The name of the leaf that is under way."""
        return self.tree_path[-1] if self.tree_path else ""

    @property
    def quantities(self) -> list[tuple[float, str]]:
        """The numbers that the leaf tells, each with the word behind it, which is mostly its unit."""
        return [(float(number), unit) for number, unit in _QUANTITY.findall(self.leaf_says)]


def under_way(tree: Sequence[Mapping[str, Any]] | None) -> tuple[tuple[str, ...], str]:
    """The deepest node of a tree that runs: names from the root down to it, and what it says.

    Args:
        tree: The nodes as the robot's status tells them: from the root down, each with its depth.
    """
    above: list[Mapping[str, Any]] = []
    deepest: list[Mapping[str, Any]] = []
    for node in tree or ():
        above[int(node["depth"]) :] = [node]
        if len(above) > len(deepest) and all(one["status"] == "running" for one in above):
            deepest = list(above)
    names = tuple(str(one["name"]) for one in deepest)
    return names, str(deepest[-1]["message"]) if deepest else ""


@dataclass(frozen=True)
class Cause:
    """A failure, without what led to it.

    Attributes:
        kind: "INFEASIBLE", "UNSAFE", ...: those of the report.
        where: The place in the tree, names joined by "/".
        message: For people.
        numbers: By name.
    """

    kind: str
    where: str
    message: str
    numbers: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Account:
    """What a task came to.

    Attributes:
        outcome: "done", "failed", "refused", "cancelled" or "question".
        message: The line for people.
        evidence: What was measured of each task: its sentence, and values by their names.
        failures: Why it was not done, each led to by the one after it.
        report: The run's report as JSON, where it was recorded.
    """

    outcome: str
    message: str
    evidence: tuple[tuple[str, Mapping[str, Any]], ...] = ()
    failures: tuple[Cause, ...] = ()
    report: str = ""


def account_of(ending: Mapping[str, Any]) -> Account:
    """What a task came to, from the message with its result and the report that this names."""
    outcome, message = str(ending["outcome"]), str(ending.get("text", ""))
    text, report = _report(str(ending.get("run", "")))
    tasks: Sequence[Mapping[str, Any]] = report.get("tasks", ())
    evidence = tuple((str(task["text"]), task["evidence"]) for task in tasks if task["evidence"])
    failure = next((task["failure"] for task in tasks if task["failure"]), None)
    chain: list[Cause] = []
    while failure is not None and len(chain) < _LONGEST_CHAIN:
        chain.append(Cause(failure["kind"], failure["where"], failure["message"], failure["numbers"]))
        failure = failure["cause"]
    return Account(outcome, message, evidence, tuple(chain), text)


def _report(folder: str) -> tuple[str, Mapping[str, Any]]:
    """A run's report, as text and read; empty where there is none."""
    try:
        text = (Path(folder) / "report.json").read_text("utf-8") if folder else ""
        return text, json.loads(text or "{}")
    except (OSError, ValueError):
        return "", {}
