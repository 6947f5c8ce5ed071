"""What is known of kinds of tasks, things, places and people when it is told what a word stands for."""

from __future__ import annotations

import importlib.resources
from collections.abc import Mapping
from dataclasses import is_dataclass
from functools import cache
from typing import Any

from executive.meaning import StopCommand
from robots.toml_text import read_toml
from trees import tasks

_KINDS = [kind for kind in (*vars(tasks).values(), StopCommand) if is_dataclass(kind)]
_TYPES = {kind.action: kind for kind in _KINDS if hasattr(kind, "action")}
"""Tasks of the grammar's own verbs by their actions, for which nobody has to ask the registry."""


def task_type(action: str) -> Any:
    """The type of the tasks of an action, such as "pick"; None where no skill has this name."""
    if action in _TYPES:
        return _TYPES[action]
    from trees.registry import skill_called  # it reads every skill's record: only when one is said

    skill = skill_called(action)
    return None if skill is None else skill.task


def listed(name: str) -> frozenset[str]:
    """The words of a list of one of the files of words, by the name that it has there."""
    return frozenset(_tables()[name])


def rules(name: str) -> tuple[Mapping[str, Any], ...]:
    """The rules of a name that stand in ``hazards.toml``."""
    return tuple(_tables()[name])


@cache
def _tables() -> Mapping[str, Any]:
    """All lists and rules, read when one is first asked for."""
    folder = importlib.resources.files("executive.language")
    return {
        name: rows if isinstance(rows[0], dict) else frozenset(rows)
        for file in ("resolve/hazards.toml", "resolve/nouns.toml", "commands/words.toml")
        for name, rows in read_toml(folder.joinpath(file).read_text("utf-8")).items()
    }
