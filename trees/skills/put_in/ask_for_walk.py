"""Say where one has to stand before something can be put there."""

from __future__ import annotations

from py_trees.common import Status

from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports
from trees.tasks import ObjectDescription, PutInTask, WalkToTask


class AskForWalk(Leaf):
    """Write the task of walking to what the object is to be put into."""

    INPUT_PORTS = ports(task=PutInTask)
    OUTPUT_PORTS = ports(walk_task=WalkToTask)
    CONTRACT = Contract(
        precondition="none",
        postcondition="the walk is described",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Describe it."""
        task: PutInTask = self.get_input("task")
        if not isinstance(task.to, str | ObjectDescription):
            return Failure.postcondition("it was not said what it is to be put into")
        noun = task.to.kind if isinstance(task.to, ObjectDescription) else task.to
        self._set_output("walk_task", WalkToTask(task.text, noun or task.to))
        return DONE
