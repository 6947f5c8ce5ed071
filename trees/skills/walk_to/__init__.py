"""Walk to furniture, things, people and rooms."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trees.skill import Need, Skill
from trees.tasks import WalkToTask

if TYPE_CHECKING:
    from py_trees.behaviour import Behaviour

    from trees.toolbox import Toolbox


def _tree(_task: WalkToTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.walk_to.tree import walk_to

    return walk_to(toolbox)


SKILL = Skill(
    task=WalkToTask, tree=_tree, example="walk to the table", needs=frozenset({Need.LEGS}), goes_away=True
)
