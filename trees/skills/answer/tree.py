"""Answer a question, here or to somebody."""

from __future__ import annotations

from trees.api import Behaviour, Toolbox, tidily
from trees.skills.answer.answer import Answer
from trees.skills.meeting.tree import met
from trees.skills.telling.who_speaks import SPEAKER


def answer(task: object, toolbox: Toolbox) -> Behaviour:
    """Go to the person whom the answer is for, if there is one, and say it. Reads "task", writes "evidence".

    Args:
        task: What is to be done; who speaks is answered from where the robot stands.
        toolbox: What leaves may call.
    """
    to_somebody = getattr(task, "person", None) not in (None, SPEAKER)
    children: list[Behaviour] = met(task, toolbox) if to_somebody else []
    children.append(Answer("answer", toolbox))
    return tidily("answer", children, toolbox, toolbox.policy.walk_timeout_s)
