"""Greet somebody."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from trees.api import Destination, Need, Skill

if TYPE_CHECKING:
    from trees.api import Behaviour, Toolbox


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


def _tree(_task: GreetTask, toolbox: Toolbox) -> Behaviour:
    raise NotImplementedError


SKILL = Skill(task=GreetTask, tree=_tree, example="greet Ana", needs=frozenset({Need.ARM}))
