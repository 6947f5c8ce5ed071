"""Turn knobs and press buttons."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trees.skill import Need, Skill
from trees.tasks import PressTask, TurnKnobTask

if TYPE_CHECKING:
    from py_trees.behaviour import Behaviour

    from trees.toolbox import Toolbox


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
        needs=frozenset({Need.HAND, Need.BARS, Need.TIPS, Need.EYES}),
    ),
    Skill(
        task=PressTask,
        tree=_press,
        example="press the button on the coffee machine",
        needs=frozenset({Need.HAND, Need.EYES}),
    ),
)
