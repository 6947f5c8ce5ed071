"""The page of the behaviors' numbers: each with its value and its reason."""

from __future__ import annotations

import dataclasses
import importlib
import pkgutil
from collections.abc import Iterator
from typing import Any

import trees.skills
from tools.documents.markdown import attributes, summary, table
from trees.policy import Gaze, TreePolicy

_HEAD = """\
# Policy: the numbers that behaviors go by

Numbers that several skills share stand in `trees.policy.TreePolicy`, those of one skill [in its
folder](#numbers-of-single-skills). Numbers of the robot (limits, gains, gait, health) are data of [its
description](../extend/a-robot.md), those of a method stand at the top of its module. A unit stands at the end
of a name.

A program hands other ones to a session, `assemble("talos", scene, seed=7, policy=TreePolicy(look_frames=12,
skills=(PickSettings(hold_s=3.0),)))`; what it leaves out is as here.
"""

_SKILLS = """\
## Numbers of single skills

A leaf asks for them by their type, `toolbox.policy.of(PickSettings)`.
"""


def policy_page() -> str:
    """The page: numbers of all skills, directions in which the eyes look, then the numbers of each skill."""
    policy = TreePolicy()
    parts = [_HEAD, _numbers(policy), "## Where the eyes look\n", *_looks(policy), _SKILLS]
    for folder, kind in _settings():
        parts.append(f"### `trees/skills/{folder}/settings.py`: `{kind.__name__}`\n")
        parts += [f"{summary(kind)}\n", _numbers(kind()), *_looks(kind())]
    return "\n".join(parts)


def _settings() -> Iterator[tuple[str, type[Any]]]:
    """Settings of the robot's own skills, with the folders that they stand in."""
    for folder in sorted(one.name for one in pkgutil.iter_modules(trees.skills.__path__) if one.ispkg):
        name = f"{trees.skills.__name__}.{folder}"
        inside = importlib.import_module(name).__path__
        if "settings" not in {one.name for one in pkgutil.iter_modules(inside)}:
            continue
        module = importlib.import_module(f"{name}.settings")
        for found in vars(module).values():
            if not isinstance(found, type) or not dataclasses.is_dataclass(found):
                continue
            if found.__module__ == module.__name__:
                yield folder, found


def _numbers(settings: Any) -> str:
    meant = attributes(type(settings))
    rows = [
        (f"`{name}`", _shown(value), meant.get(name, ""))
        for name, value in _values(settings)
        if not _gazes(value)
    ]
    return table(("name", "value", "meaning"), rows)


def _looks(settings: Any) -> Iterator[str]:
    meant = attributes(type(settings))
    for name, value in _values(settings):
        if gazes := _gazes(value):
            yield f"**`{name}`**: {meant.get(name, '')}\n"
            yield _directions(gazes)


def _values(settings: Any) -> Iterator[tuple[str, Any]]:
    return ((field.name, getattr(settings, field.name)) for field in dataclasses.fields(settings))


def _directions(gazes: tuple[Gaze, ...]) -> str:
    names = [field.name for field in dataclasses.fields(Gaze)]
    rows = [[_shown(getattr(gaze, name)) for name in names] for gaze in gazes]
    return table([f"`{name}`" for name in names], rows)


def _gazes(value: object) -> tuple[Gaze, ...]:
    several = value if isinstance(value, tuple) else (value,)
    return tuple(one for one in several if isinstance(one, Gaze))


def _shown(value: object) -> str:
    return f"{value:.4g}" if isinstance(value, float) else str(value)
