"""Let time pass."""

from __future__ import annotations

from py_trees.common import Status

from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, RUNNING, Leaf
from trees.nodes.ports import ports
from trees.tasks import WaitTask
from trees.toolbox import Toolbox

# One tick comes after the time is up.
_ALLOWANCE_S = 1.0


class Wait(Leaf):
    """Hold still for the time that the task says."""

    INPUT_PORTS = ports(task=WaitTask)
    OUTPUT_PORTS = ports(evidence=dict)
    CONTRACT = Contract("none", "the time has passed on the clock", deadline_s=_ALLOWANCE_S)

    def step(self) -> Status | Failure:
        """Look at the clock."""
        wanted_s = self.get_input("task").duration_s
        if self.elapsed_s < wanted_s:
            self.feedback_message = f"{self.elapsed_s:.1f} of {wanted_s:.1f} s"
            return RUNNING
        self._set_output("evidence", {"waited_s": self.elapsed_s})
        return DONE

    @property
    def deadline_s(self) -> float:
        """The task's time, and the contract's allowance."""
        return float(self.get_input("task").duration_s) + self.CONTRACT.deadline_s


class Hold(Leaf):
    """Hold still for a time that the tree says."""

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()
    CONTRACT = Contract("none", "the time has passed on the clock", deadline_s=_ALLOWANCE_S)

    def __init__(self, name: str, toolbox: Toolbox, duration_s: float) -> None:
        super().__init__(name, toolbox)
        self._duration_s = duration_s

    def step(self) -> Status | Failure:
        """Look at the clock."""
        return RUNNING if self.elapsed_s < self._duration_s else DONE

    @property
    def deadline_s(self) -> float:
        """The time, and the contract's allowance."""
        return self._duration_s + self.CONTRACT.deadline_s
