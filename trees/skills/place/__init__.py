"""Put what is held down."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trees.skill import After, Before, Need, Skill
from trees.tasks import WHERE_IT_WAS, Destination, PlaceTask

if TYPE_CHECKING:
    from py_trees.behaviour import Behaviour

    from trees.toolbox import Toolbox


def _tree(_task: PlaceTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.place.tree import place

    return place(toolbox)


def _goal(task: PlaceTask) -> Destination | None:
    """Where it was; or else what it is put on, or beside what."""
    return task.to if task.to == WHERE_IT_WAS else task.on or task.to


SKILL = Skill(
    task=PlaceTask,
    tree=_tree,
    example="put the red cup next to the bottle",
    needs=frozenset({Need.HAND}),
    before=frozenset({Before.THING_AT_HAND, Before.THING_HELD, Before.AT_GOAL, Before.AT_SURFACE}),
    after=frozenset({After.THING_LEFT}),
    goal=_goal,
)
