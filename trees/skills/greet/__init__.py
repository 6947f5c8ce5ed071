"""Greet somebody."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from trees.api import Before, Destination, Need, Skill

if TYPE_CHECKING:
    from trees.api import Behaviour, Evidence, Toolbox


@dataclass(frozen=True, slots=True)
class GreetTask:
    """Go to a person, face the person, wave and say hello.

    Attributes:
        text: The sentence that it came from.
        person: Whom to greet.
        source: Where the person is said to be, or None.
        introducing: Whether the robot says who it is.
    """

    text: str
    person: Destination | None = None
    source: Destination | None = None
    introducing: bool = False

    action = "greet"


def _tree(task: GreetTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.greet.tree import greet

    return greet(task, toolbox)


def _claim(text: str, _subject: str, evidence: Evidence) -> str:
    """That nobody waved is told."""
    return text if evidence.get("swings", 0) else f"{text}, without waving"


SKILL = Skill(
    task=GreetTask,
    tree=_tree,
    example="greet Ana",
    claim=_claim,
    needs=frozenset({Need.ARM, Need.EYES}),
    before=frozenset({Before.SOURCE_IN_VIEW, Before.PERSON_KNOWN}),
    goes_away=True,
)
