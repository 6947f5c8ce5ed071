"""The page of the behaviors' numbers: each with its value and its reason."""

from __future__ import annotations

import dataclasses

from tools.documents.markdown import attributes, table
from trees.policy import Gaze, TreePolicy

_HEAD = """\
# Policy: the numbers that behaviors go by

`trees.policy.TreePolicy` holds them; a program may hand another one to a session. Numbers of the robot
(limits, gains, gait, health) are data of [its description](../extend/a-robot.md), those of a method stand
at the top of its module. A unit stands at the end of a name.
"""


def policy_page() -> str:
    """The page: one table of numbers, one of the directions in which the eyes look."""
    policy, meant = TreePolicy(), attributes(TreePolicy)
    fields = dataclasses.fields(TreePolicy)
    numbers = [
        (f"`{field.name}`", _shown(getattr(policy, field.name)), meant.get(field.name, ""))
        for field in fields
        if not _gazes(getattr(policy, field.name))
    ]
    looks = [(field.name, meant.get(field.name, ""), _gazes(getattr(policy, field.name))) for field in fields]
    parts = [_HEAD, table(("name", "value", "meaning"), numbers), "## Where the eyes look\n"]
    for name, meaning, gazes in looks:
        if gazes:
            parts += [f"**`{name}`**: {meaning}\n", _directions(gazes)]
    return "\n".join(parts)


def _directions(gazes: tuple[Gaze, ...]) -> str:
    names = [field.name for field in dataclasses.fields(Gaze)]
    rows = [[_shown(getattr(gaze, name)) for name in names] for gaze in gazes]
    return table([f"`{name}`" for name in names], rows)


def _gazes(value: object) -> tuple[Gaze, ...]:
    several = value if isinstance(value, tuple) else (value,)
    return tuple(one for one in several if isinstance(one, Gaze))


def _shown(value: object) -> str:
    return f"{value:.4g}" if isinstance(value, float) else str(value)
