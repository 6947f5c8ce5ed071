"""Every skill there is, the robot's own and those of installed packages: whoever wants to know asks here."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from types import MappingProxyType
from typing import Any

from trees.extensions import extensions
from trees.skill import After, Skill
from trees.skills import built_in
from trees.tasks import Task


@cache
def skills() -> Mapping[str, Skill]:
    """All skills by the names of their actions, sorted: first the robot's own, then installed ones.

    It loads installed packages; ``skill_called`` and ``skill_of`` do so only for what is not built in.
    """
    return MappingProxyType({**built_in(), **dict(sorted(extensions().skills.items()))})


def skill_called(action: str) -> Skill | None:
    """The skill of an action, or None.

    Args:
        action: Its name, "pick".
    """
    own = built_in().get(action)
    return extensions().skills.get(action) if own is None else own


def skill_of(task: Task) -> Skill | None:
    """The skill that carries a task out, or None."""
    found = skill_called(task.action)
    return found if found is not None and type(task) is found.task else None


def task_that(brings_about: After, text: str, **slots: Any) -> Any:
    """The task that brings something about which another task needs first.

    Args:
        brings_about: What has to be true.
        text: What it is called where people are told of it: "pick up the red cup".
        slots: What it is about, by the names that ``After`` gives them; others as its task type has them.

    Raises:
        LookupError: No skill of the robot brings that about.
    """
    skill = next((one for one in built_in().values() if brings_about in one.after), None)
    if skill is None:
        raise LookupError(f"no skill of this robot brings about that {brings_about.value}")
    return skill.task(text, **slots)
