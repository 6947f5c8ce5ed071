"""Velocities for a while."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from trees.skill import Need, Skill
from trees.tasks import MoveTask

if TYPE_CHECKING:
    from py_trees.behaviour import Behaviour

    from trees.toolbox import Toolbox


AWAY_RAD = 0.7
"""Heads turn farther than this by themselves: what was ahead is in view still."""
AWAY_M = 0.5
"""Hands do not get to what was in the middle of their reach."""


def leads_away(task: MoveTask) -> bool:
    """Whether the robot is away from what was at hand after a velocity; one without an end leads anywhere."""
    seconds = math.inf if task.duration_s is None else task.duration_s
    turn_rad = abs(task.angular_rad_s) * seconds if task.angular_rad_s else 0.0
    far_m = abs(task.linear_m_s) * seconds if task.linear_m_s else 0.0
    if task.distance_m is not None:
        far_m = min(far_m, abs(task.distance_m))
    return turn_rad > AWAY_RAD or far_m > AWAY_M


def _tree(task: MoveTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.moving.drive import drive
    from trees.skills.moving.tree import move

    return drive(toolbox) if task.is_fed else move(toolbox)


SKILL = Skill(
    task=MoveTask,
    tree=_tree,
    example="move forward for 2 seconds",
    needs=frozenset({Need.LEGS}),
    strays=leads_away,
)
