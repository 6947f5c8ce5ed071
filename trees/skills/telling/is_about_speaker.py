"""Tell whether a task is about who speaks."""

from __future__ import annotations

from py_trees.common import Status

from trees.beliefs.grounding.destination import aim_of
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports

SPEAKER = "me"


class AsksForSpeaker(Leaf):
    """Succeed if the task is aimed at "me", the person who speaks to the robot."""

    ASKS = True
    INPUT_PORTS = ports(task=object)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="none",
        postcondition="the task is aimed at who speaks",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Look at the word."""
        if aim_of(self.get_input("task")) != SPEAKER:
            return Failure.postcondition("it is not about who speaks")
        return DONE
