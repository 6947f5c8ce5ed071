"""Pick an object up."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trees.skill import After, Before, Evidence, Need, Skill
from trees.tasks import PickTask

if TYPE_CHECKING:
    from py_trees.behaviour import Behaviour

    from trees.toolbox import Toolbox


_MEASURED = (
    ("gripper_opening_m", 1000.0, "opening {:.0f} mm"),
    ("effort_nm", 1.0, "effort {:.1f} Nm"),
    ("effort_n", 1.0, "effort {:.1f} N"),
    ("lift_m", 1.0, "lifted {:.2f} m"),
)
"""What is told of the evidence: its name, what it is multiplied by, and how it reads."""


def _claim(_text: str, subject: str, evidence: Evidence) -> str:
    """What is held, in which hand, and how that was measured."""
    hand = f" in the {evidence['hand']} hand" if "hand" in evidence else ""
    numbers = [
        told.format(value * factor)
        for name, factor, told in _MEASURED
        if isinstance(value := evidence.get(name), int | float)
    ]
    return ", ".join([f"{subject or 'object'} held{hand}", *numbers])


def _tree(_task: PickTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.pick.tree import pick

    return pick(toolbox)


SKILL = Skill(
    task=PickTask,
    tree=_tree,
    example="pick up the red cup on the table",
    verb="pick up",
    claim=_claim,
    needs=frozenset({Need.HAND}),
    before=frozenset({Before.THING_AT_HAND, Before.SOURCE_OPEN}),
    after=frozenset({After.THING_HELD}),
)
