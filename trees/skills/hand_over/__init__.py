"""Give what is held to a person."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trees.skill import Before, Need, Skill
from trees.tasks import HandOverTask

if TYPE_CHECKING:
    from py_trees.behaviour import Behaviour

    from trees.toolbox import Toolbox


def _tree(_task: HandOverTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.hand_over.tree import hand_over

    return hand_over(toolbox)


SKILL = Skill(
    task=HandOverTask,
    tree=_tree,
    example="give the red cup to Ana",
    verb="give",
    toward="to",
    needs=frozenset({Need.HAND, Need.EYES}),
    before=frozenset({Before.THING_AT_HAND, Before.THING_HELD, Before.AT_GOAL}),
)
