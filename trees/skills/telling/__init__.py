"""Count, describe, find: answers about what is seen."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trees.skill import After, Before, Skill, Written, as_answered
from trees.tasks import CountTask, DescribeTask, FindTask

if TYPE_CHECKING:
    from py_trees.behaviour import Behaviour

    from trees.toolbox import Toolbox


def _find(task: FindTask, toolbox: Toolbox) -> Behaviour:
    """Another one for several things."""
    from trees.skills.telling.tree import find, find_several

    several = task.count != 1 and not isinstance(task.person, str)
    return find_several(task, toolbox) if several else find(toolbox)


def _found(written: Written) -> str | None:
    """The thing that was found; people are told apart by their names, and "it" is none of them."""
    place = written("place")
    return place.name if place is not None and place.category == "object" else None


def _count(task: CountTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.telling.tree import count

    return count(task, toolbox)


def _describe(task: DescribeTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.telling.tree import describe

    return describe(task, toolbox)


SKILLS = (
    Skill(
        task=FindTask,
        tree=_find,
        example="find the red cup",
        claim=as_answered,
        before=frozenset({Before.SOURCE_IN_VIEW}),
        after=frozenset({After.PERSON_KNOWN}),
        about=_found,
    ),
    Skill(
        task=CountTask,
        tree=_count,
        example="how many cups are there",
        claim=as_answered,
        before=frozenset({Before.SOURCE_IN_VIEW}),
        hands_stay=True,
    ),
    Skill(
        task=DescribeTask,
        tree=_describe,
        example="what is on the table",
        claim=as_answered,
        before=frozenset({Before.SOURCE_IN_VIEW}),
        hands_stay=True,
    ),
)
