"""Which task a verb makes: those of the grammar's own verbs, and those of every skill that has words."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

from executive.meaning import StopCommand
from trees import tasks

TYPES: Mapping[str, Any] = MappingProxyType(
    {
        "pick": tasks.PickTask,
        "place": tasks.PlaceTask,
        "put_in": tasks.PutInTask,
        "hand_over": tasks.HandOverTask,
        "open": tasks.OpenTask,
        "close": tasks.CloseTask,
        "walk_to": tasks.WalkToTask,
        "move": tasks.MoveTask,
        "wave": tasks.WaveTask,
        "point_at": tasks.PointAtTask,
        "look_at": tasks.LookAtTask,
        "find": tasks.FindTask,
        "count": tasks.CountTask,
        "describe": tasks.DescribeTask,
        "say": tasks.SayTask,
        "wait": tasks.WaitTask,
        "go_home": tasks.GoHomeTask,
        "stop": StopCommand,
    }
)
"""By the names of actions: those of the grammar's own verbs, for which nobody has to ask the registry."""


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
