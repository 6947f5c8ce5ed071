"""Answer what a person asks about the time and about the robot."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from trees.api import Before, Destination, Skill, as_answered

if TYPE_CHECKING:
    from trees.api import Behaviour, Toolbox


@dataclass(frozen=True, slots=True)
class AnswerTask:
    """Tell the time, the day, or something about the robot.

    Attributes:
        text: The sentence that it came from.
        question: What is asked: "time", "day", "date", "tomorrow", "day of the week", "day of the month",
            "name", "team", "country", "affiliation" or "about yourself".
        person: To whom, or None: to who speaks.
    """

    text: str
    question: str
    person: Destination | None = None

    action = "answer"


def _tree(task: AnswerTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.answer.tree import answer

    return answer(task, toolbox)


SKILL = Skill(
    task=AnswerTask,
    tree=_tree,
    example="tell me the time",
    claim=as_answered,
    before=frozenset({Before.PERSON_KNOWN}),
    goes_away=True,
)
