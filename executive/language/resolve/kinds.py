"""What is known of kinds of tasks, things, places and people when it is told what a word stands for."""

from __future__ import annotations

import importlib.resources
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from functools import cache
from types import MappingProxyType
from typing import Any

from executive.meaning import StopCommand
from robots.toml_text import read_toml
from trees import tasks

TYPES: Mapping[str, Any] = MappingProxyType(
    {
        kind.action: kind
        for kind in (*vars(tasks).values(), StopCommand)
        if is_dataclass(kind) and hasattr(kind, "action")
    }
)
"""Tasks by the names of their actions: the grammar's own verbs, for which nobody has to ask the registry."""

TAKES_SEVERAL = frozenset(
    name for name, kind in TYPES.items() if any(one.name == "count" for one in fields(kind))
)
"""Actions that may be done to several things at once."""


def task_type(action: str) -> Any:
    """The type of the tasks of an action; None where no skill has this name.

    Args:
        action: Its name, "pick".
    """
    if action in TYPES:
        return TYPES[action]
    from trees.registry import skill_called  # it reads every skill's record: only when one is said

    skill = skill_called(action)
    return None if skill is None else skill.task


def listed(name: str) -> frozenset[str]:
    """The words of a list of ``hazards.toml`` or ``nouns.toml``, by the name that it has there."""
    words: frozenset[str] = _tables()[name]
    return words


def rules(name: str) -> tuple[Mapping[str, Any], ...]:
    """The rules of a name that stand in ``hazards.toml``."""
    found: tuple[Mapping[str, Any], ...] = _tables()[name]
    return found


@cache
def _tables() -> Mapping[str, Any]:
    """All lists and rules, read when one is first asked for."""
    folder = importlib.resources.files("executive.language.resolve")
    return {
        name: tuple(rows) if isinstance(rows[0], dict) else frozenset(rows)
        for file in ("hazards.toml", "nouns.toml")
        for name, rows in read_toml(folder.joinpath(file).read_text("utf-8")).items()
    }
