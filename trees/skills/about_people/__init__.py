"""Tell who somebody is, and how somebody is seen."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from trees.api import Before, Destination, Need, Skill, as_answered

if TYPE_CHECKING:
    from trees.api import Behaviour, Toolbox


@dataclass(frozen=True, slots=True)
class TellTask:
    """Tell the name, the pose, the gesture or the clothes of a person.

    Attributes:
        text: The sentence that it came from.
        about: What is told: name, pose, gesture or clothes.
        of: Whose.
        source: Where that person is said to be, or None.
        person: To whom, or None: to who speaks.
    """

    text: str
    about: str
    of: Destination
    source: Destination | None = None
    person: Destination | None = None

    action = "tell"


def _tree(task: TellTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.about_people.tree import tell

    return tell(task, toolbox)


SKILL = Skill(
    task=TellTask,
    tree=_tree,
    example="tell me the name of the person in the kitchen",
    claim=as_answered,
    needs=frozenset({Need.EYES}),
    before=frozenset({Before.SOURCE_IN_VIEW, Before.PERSON_KNOWN}),
    goes_away=True,
)
