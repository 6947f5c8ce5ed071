"""Turn knobs and press buttons."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from trees.skill import Need, Skill
from trees.tasks import Thing

if TYPE_CHECKING:
    from py_trees.behaviour import Behaviour

    from kinematics.model.robot_description import Hand
    from trees.toolbox import Toolbox


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


def _turn(_task: TurnKnobTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.controls.turn_knob import turn_knob

    return turn_knob(toolbox)


def _press(_task: PressTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.controls.press import press

    return press(toolbox)


SKILLS = (
    Skill(
        task=TurnKnobTask,
        tree=_turn,
        example="turn on the stove",
        verb="turn the knob of",
        needs=frozenset({Need.HAND}),
    ),
    Skill(
        task=PressTask,
        tree=_press,
        example="press the button on the coffee machine",
        needs=frozenset({Need.HAND}),
    ),
)
