"""Walk ahead of somebody."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from trees.api import Before, Destination, Need, Skill

if TYPE_CHECKING:
    from trees.api import Behaviour, Toolbox


@dataclass(frozen=True, slots=True)
class GuideTask:
    """Lead a person to a place, looking round for the person on the way.

    Attributes:
        text: The sentence that it came from.
        person: Whom to lead.
        source: Where the person is said to be, or None.
        to: Where to.
    """

    text: str
    person: Destination | None = None
    source: Destination | None = None
    to: Destination | None = None

    action = "guide"


def _tree(_task: GuideTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.guide.tree import guide

    return guide(toolbox)


SKILL = Skill(
    task=GuideTask,
    tree=_tree,
    example="guide Ana to the kitchen",
    needs=frozenset({Need.LEGS, Need.EYES}),
    before=frozenset({Before.SOURCE_IN_VIEW}),
    goes_away=True,
)
