"""A skill that leaves the robot at home when it fails."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.leaves.go_home import GoHome
from trees.nodes.clean_up import CleanUp
from trees.nodes.deadline import Deadline
from trees.nodes.judgements import tidying_helps
from trees.toolbox import Toolbox


class _Main(Sequence):
    """What is to be done; it is left out of places in the tree."""

    transparent = True


def tidily(name: str, children: list[Behaviour], toolbox: Toolbox, timeout_s: float | None = None) -> CleanUp:
    """One thing after the other, in time; after a failure that is no question, home.

    Args:
        name: Of the node.
        children: What is to be done.
        toolbox: What leaves may call.
        timeout_s: All of it takes less; the policy's time for a task when left out.
    """
    main = _Main("do", memory=True, children=children)
    limit_s = toolbox.policy.task_timeout_s if timeout_s is None else timeout_s
    timed = Deadline("in time", main, limit_s, toolbox.clock, toolbox.pauses)
    return CleanUp(name, timed, GoHome("go home", toolbox), worth_it=tidying_helps)
