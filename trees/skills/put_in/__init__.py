"""Put what is held into a container, behind a door if need be."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trees.skill import Before, Need, Skill
from trees.tasks import PutInTask

if TYPE_CHECKING:
    from py_trees.behaviour import Behaviour

    from trees.toolbox import Toolbox


def _tree(task: PutInTask, toolbox: Toolbox) -> Behaviour:
    """Another one for what is behind a door."""
    from trees.beliefs.openings.fridge_inside import is_behind_door
    from trees.skills.put_in.put_behind_door import put_behind_door
    from trees.skills.put_in.tree import put_in

    return put_behind_door(toolbox) if is_behind_door(task.to) else put_in(toolbox)


SKILL = Skill(
    task=PutInTask,
    tree=_tree,
    example="put the can in the box",
    verb="put",
    toward="in",
    needs=frozenset({Need.HAND}),
    before=frozenset({Before.THING_AT_HAND, Before.THING_HELD, Before.AT_GOAL, Before.GOAL_OPEN}),
)
