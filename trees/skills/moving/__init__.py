"""Velocities for a while."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trees.skill import Need, Skill
from trees.tasks import MoveTask

if TYPE_CHECKING:
    from py_trees.behaviour import Behaviour

    from trees.toolbox import Toolbox


def _tree(task: MoveTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.moving.tree import drive, move

    return drive(toolbox) if task.is_fed else move(toolbox)


SKILL = Skill(
    task=MoveTask,
    tree=_tree,
    example="move forward for 2 seconds",
    needs=frozenset({Need.LEGS}),
    goes_away=True,
)
