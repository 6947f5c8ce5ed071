"""Press a button."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from trees.api import Hand, Need, Skill, Thing

if TYPE_CHECKING:
    from trees.api import Behaviour, Toolbox


@dataclass(frozen=True, slots=True)
class PressTask:
    """Press a button, or that of the thing that is named.

    Attributes:
        text: The sentence that it came from.
        object: The button, or what it belongs to.
        hand: The hand to use, or None for the better one.
    """

    text: str
    object: Thing
    hand: Hand | None = None

    action = "press"


def _tree(_task: PressTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.press.tree import press

    return press(toolbox)


SKILL = Skill(
    task=PressTask, tree=_tree, example="press the button on the coffee machine", needs=frozenset({Need.HAND})
)
