"""Say and wait."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trees.skill import Skill
from trees.tasks import SayTask, WaitTask

if TYPE_CHECKING:
    from py_trees.behaviour import Behaviour

    from trees.toolbox import Toolbox


def _say(_task: SayTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.talking.tree import say

    return say(toolbox)


def _wait(_task: WaitTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.talking.tree import wait

    return wait(toolbox)


def _as_said(task: WaitTask) -> float:
    return task.duration_s


SKILLS = (
    Skill(task=SayTask, tree=_say, example="say hello", toward="to", hands_stay=True),
    Skill(task=WaitTask, tree=_wait, example="wait 5 seconds", hands_stay=True, lasts_s=_as_said),
)
