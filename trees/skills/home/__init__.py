"""Back to the home posture, with whatever is in the hands."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trees.skill import Evidence, Skill
from trees.tasks import GoHomeTask

if TYPE_CHECKING:
    from py_trees.behaviour import Behaviour

    from trees.toolbox import Toolbox


def _tree(_task: GoHomeTask, toolbox: Toolbox) -> Behaviour:
    from trees.skills.home.tree import go_home

    return go_home(toolbox)


def _claim(_text: str, _subject: str, _evidence: Evidence) -> str:
    return "at the home posture"


SKILL = Skill(task=GoHomeTask, tree=_tree, example="go home", claim=_claim)
