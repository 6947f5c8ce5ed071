"""Tell whether the robot has to do it from where it stands."""

from __future__ import annotations

from py_trees.common import Status

from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports


class CannotWalk(Leaf):
    """Succeed if the robot cannot walk here, and so has to do the task from where it stands."""

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="none",
        postcondition="the robot stands where it stands",
        deadline_s=1.0,
    )
    ASKS = True

    def step(self) -> Status | Failure:
        """Ask what there is to walk with."""
        return Failure.postcondition("it can walk") if self.toolbox.can_walk else DONE
