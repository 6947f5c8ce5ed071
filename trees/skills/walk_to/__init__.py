"""Walk to furniture, things, people and rooms."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trees.skill import After, Need, Skill, Written
from trees.tasks import WalkToTask

if TYPE_CHECKING:
    from py_trees.behaviour import Behaviour

    from trees.toolbox import Toolbox


def _tree(_task: WalkToTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.walk_to.tree import walk_to

    return walk_to(toolbox)


def _about(written: Written) -> str | None:
    """The thing that was walked to; furniture, people and places are not what "it" is then."""
    place = written("place")
    return place.name if place is not None and place.category == "object" else None


SKILL = Skill(
    task=WalkToTask,
    tree=_tree,
    example="walk to the table",
    needs=frozenset({Need.LEGS, Need.EYES}),
    after=frozenset({After.AT_GOAL}),
    about=_about,
    goes_away=True,
)
