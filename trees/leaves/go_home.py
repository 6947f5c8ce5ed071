"""Go home: alone, or as what a skill does after it has failed."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from kinematics.requests.gesture import GestureRequest
from kinematics.requests.move import MoveRequest
from trees.failures import Failure
from trees.nodes.arrival import is_told_to_be_home
from trees.nodes.clean_up import CleanUp
from trees.nodes.contract import Contract
from trees.nodes.deadline import Deadline
from trees.nodes.judgements import tidying_helps
from trees.nodes.planned_motion_leaf import PlannedMotionLeaf, move_from_here
from trees.nodes.ports import ports
from trees.toolbox import Toolbox


class GoHome(PlannedMotionLeaf):
    """Bring arms, trunk and head to the home posture; fingers stay as they are, with what they hold."""

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="none",
        postcondition="every body joint is measured to be at home",
        deadline_s=30.0,
        moves="body",
        on_success="the robot holds the home posture",
    )

    def goal(self) -> MoveRequest | GestureRequest | Failure | None:
        """The home posture, unless it is commanded already."""
        return None if is_told_to_be_home(self.toolbox) else move_from_here(self.toolbox)


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
