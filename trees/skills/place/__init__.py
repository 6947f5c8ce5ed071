"""Put what is held down."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trees.skill import Before, Need, Skill
from trees.tasks import PlaceTask

if TYPE_CHECKING:
    from py_trees.behaviour import Behaviour

    from trees.toolbox import Toolbox


def _tree(_task: PlaceTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.place.tree import place

    return place(toolbox)


SKILL = Skill(
    task=PlaceTask,
    tree=_tree,
    example="put the red cup next to the bottle",
    needs=frozenset({Need.HAND}),
    before=frozenset({Before.THING_AT_HAND, Before.THING_HELD, Before.AT_GOAL}),
)
