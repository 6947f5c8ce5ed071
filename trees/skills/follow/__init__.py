"""Walk behind somebody."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from trees.api import Before, Destination, Need, Skill

if TYPE_CHECKING:
    from trees.api import Behaviour, Toolbox


@dataclass(frozen=True, slots=True)
class FollowTask:
    """Walk behind a person, and stop where the person stops.

    Attributes:
        text: The sentence that it came from.
        person: Whom to follow.
        source: Where the person is said to be, or None.
        to: Where it ends, or None: when the person has stood still for a while, or somebody says stop.
    """

    text: str
    person: Destination | None = None
    source: Destination | None = None
    to: Destination | None = None

    action = "follow"


def _tree(_task: FollowTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.follow.tree import follow

    return follow(toolbox)


SKILL = Skill(
    task=FollowTask,
    tree=_tree,
    example="follow Ana",
    needs=frozenset({Need.LEGS, Need.EYES}),
    before=frozenset({Before.SOURCE_IN_VIEW}),
    goes_away=True,
)
