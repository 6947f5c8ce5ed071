"""Skills that other packages bring, found by their entry points.

A package declares in its ``pyproject.toml``::

    [project.entry-points."humanoid_executive.skills"]
    bow = "my_package.bow:BOW"

and ``BOW`` is a ``Skill``, as the robot's own records are. One that cannot be loaded is left out, and its
error is kept to be told; nothing of it is half there.
"""

from __future__ import annotations

import importlib.metadata
from collections.abc import Container, Mapping
from dataclasses import dataclass, fields, is_dataclass
from functools import cache
from types import MappingProxyType
from typing import Any

from trees.skill import Skill
from trees.skills import built_in

GROUP = "humanoid_executive.skills"
LEAVES = "humanoid_executive.leaves"


@dataclass(frozen=True, slots=True)
class Extensions:
    """The skills of other packages, as far as they could be loaded.

    Attributes:
        skills: By the name of their action.
        complaints: Why an entry point was not loaded, one line each.
    """

    skills: Mapping[str, Skill]
    complaints: tuple[str, ...] = ()

    @property
    def packages(self) -> frozenset[str]:
        """Names of the top-level packages that skills come from."""
        return frozenset(skill.tree.__module__.partition(".")[0] for skill in self.skills.values())

    def for_phrase(self, text: str) -> Any | None:
        """The task that a sentence means to a skill from outside, or None."""
        plain = " ".join(text.lower().split()).rstrip(".!")
        for skill in self.skills.values():
            if plain in skill.phrases:
                return skill.task_of(text)
        return None


@cache
def extensions() -> Extensions:
    """All skills from outside, loaded once."""
    return load(importlib.metadata.entry_points(group=GROUP), built_in())


def load(points: Any, taken: Container[str] = ()) -> Extensions:
    """Load entry points, those with the smaller names first.

    Args:
        points: Entry points of the group.
        taken: Names of actions that none of them may have.
    """
    skills: dict[str, Skill] = {}
    complaints = []
    for point in sorted(points, key=lambda one: str(one.name)):
        try:
            found = point.load()
        except Exception as broken:
            complaints.append(f"skill {point.name!r}: {type(broken).__name__}: {broken}")
            continue
        if not isinstance(found, Skill) or not _is_task(found.task):
            complaints.append(f"skill {point.name!r} is no Skill whose task has a text and an action")
        elif found.action in skills or found.action in taken:
            complaints.append(f"skill {point.name!r}: there is a skill {found.action!r} already")
        else:
            skills[found.action] = found
    return Extensions(MappingProxyType(skills), tuple(complaints))


def _is_task(kind: type[Any]) -> bool:
    has_text = is_dataclass(kind) and any(field.name == "text" for field in fields(kind))
    return has_text and isinstance(getattr(kind, "action", None), str)
