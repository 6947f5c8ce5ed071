"""Turn a knob: switch something on or off."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from trees.api import Hand, Need, Skill, Thing

if TYPE_CHECKING:
    from trees.api import Behaviour, Toolbox


@dataclass(frozen=True, slots=True)
class TurnKnobTask:
    """Turn a knob, or that of what is switched on or off by it.

    Attributes:
        text: The sentence that it came from.
        object: The knob, or what it belongs to: "stove".
        off: Whether it is turned back, instead of on.
        hand: The hand to use, or None for the better one.
    """

    text: str
    object: Thing
    off: bool = False
    hand: Hand | None = None

    action = "turn_knob"


def _tree(_task: TurnKnobTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.turn_knob.tree import turn_knob

    return turn_knob(toolbox)


SKILL = Skill(task=TurnKnobTask, tree=_tree, example="turn on the stove", needs=frozenset({Need.HAND}))
