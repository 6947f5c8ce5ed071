"""Skills that other packages bring, found by their entry points.

A package declares in its ``pyproject.toml``::

    [project.entry-points."humanoid_executive.skills"]
    bow = "my_package.bow:BOW"

and ``BOW`` is a ``SkillExtension``. One that cannot be loaded is left out, and its error is kept to be
told; nothing of it is half there.
"""

from __future__ import annotations

import importlib.metadata
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:  # whoever only parses a sentence asks for skills too: what they act on is not loaded for it
    from py_trees.behaviour import Behaviour

    from trees.toolbox import Toolbox

GROUP = "humanoid_executive.skills"
LEAVES = "humanoid_executive.leaves"


@dataclass(frozen=True, slots=True)
class SkillExtension:
    """A skill that another package brings: the tasks it carries out, its tree, and what people say for it.

    Attributes:
        task: Type of the tasks that it carries out: a frozen dataclass with ``text`` and ``action``.
        tree: Makes the tree; its leaves read the task at the port "task" and write "evidence".
        example: A sentence for it.
        phrases: What people say for it, lower-case; each is understood as a task without further slots.
        make: Makes a task of the text that was said; ``task(text)`` when left out.
    """

    task: type[Any]
    tree: Callable[[Toolbox], Behaviour]
    example: str
    phrases: tuple[str, ...] = ()
    make: Callable[[str], Any] | None = None


@dataclass(frozen=True, slots=True)
class Extensions:
    """The skills of other packages, as far as they could be loaded.

    Attributes:
        skills: By the name of their action.
        complaints: Why an entry point was not loaded, one line each.
    """

    skills: Mapping[str, SkillExtension]
    complaints: tuple[str, ...] = ()

    @property
    def packages(self) -> frozenset[str]:
        """Names of the top-level packages that skills come from."""
        return frozenset(skill.tree.__module__.partition(".")[0] for skill in self.skills.values())

    def for_task(self, task: object) -> SkillExtension | None:
        """The skill that carries a task out, or None."""
        return next((skill for skill in self.skills.values() if type(task) is skill.task), None)

    def for_phrase(self, text: str) -> Any | None:
        """The task that a sentence means to a skill from outside, or None."""
        plain = " ".join(text.lower().split()).rstrip(".!")
        for skill in self.skills.values():
            if plain in skill.phrases:
                return (skill.make or skill.task)(text)
        return None


@cache
def extensions() -> Extensions:
    """All skills from outside, loaded once."""
    return load(importlib.metadata.entry_points(group=GROUP))


def load(points: Any) -> Extensions:
    """Load entry points, those with the smaller names first.

    Args:
        points: Entry points of the group.
    """
    skills: dict[str, SkillExtension] = {}
    complaints = []
    for point in sorted(points, key=lambda one: str(one.name)):
        try:
            found = point.load()
        except Exception as broken:
            complaints.append(f"skill {point.name!r}: {type(broken).__name__}: {broken}")
            continue
        action = getattr(getattr(found, "task", None), "action", None)
        if not isinstance(found, SkillExtension) or not isinstance(action, str):
            complaints.append(f"skill {point.name!r} is no SkillExtension with a task that has an action")
        elif action in skills:
            complaints.append(f"skill {point.name!r}: there is a skill {action!r} already")
        else:
            skills[action] = found
    return Extensions(MappingProxyType(skills), tuple(complaints))
