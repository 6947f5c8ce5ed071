"""One folder a skill: its record, its tree, its leaves, its geometry."""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Iterator, Mapping
from functools import cache
from types import MappingProxyType

from trees.skill import Skill


@cache
def built_in() -> Mapping[str, Skill]:
    """The robot's own skills by the names of their actions: the records of the folders beside this file.

    Raises:
        TypeError: A folder's record is no ``Skill``, or two of them have the same action.
    """
    found: dict[str, Skill] = {}
    for folder in sorted(one.name for one in pkgutil.iter_modules(__path__) if one.ispkg):
        for skill in _records(folder):
            if skill.action in found:
                raise TypeError(f"trees/skills/{folder}: there is a skill {skill.action!r} already")
            found[skill.action] = skill
    return MappingProxyType(dict(sorted(found.items())))


def _records(folder: str) -> Iterator[Skill]:
    """The record of one folder, those of several, or none: some folders hold what several skills share."""
    module = importlib.import_module(f"{__name__}.{folder}")
    records = [*([module.SKILL] if hasattr(module, "SKILL") else []), *getattr(module, "SKILLS", ())]
    for record in records:
        if not isinstance(record, Skill):
            raise TypeError(f"trees/skills/{folder}: SKILL must be a Skill, not {type(record).__name__}")
        yield record
