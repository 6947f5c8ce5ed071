"""Tell whether a question is about more than what stands in front of the robot."""

from __future__ import annotations

from py_trees.common import Status

from trees.believed_thing import PERSON
from trees.contract import Contract
from trees.failures import Failure
from trees.leaf import DONE, Leaf
from trees.ports import ports
from trees.tasks import CountTask, DescribeTask, ObjectDescription
from trees.toolbox import Toolbox


class AsksFarther(Leaf):
    """Succeed when the task asks about people, about a room, or about everything; or only about a room."""

    ASKS = True
    INPUT_PORTS = ports(task=object)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="none",
        postcondition="what the task asks about may be farther away than hands reach",
        deadline_s=1.0,
    )

    def __init__(self, name: str, toolbox: Toolbox, *, room: bool = False) -> None:
        """Make the leaf.

        Args:
            name: Its name.
            toolbox: What it may call.
            room: Whether only a room counts.
        """
        super().__init__(name, toolbox)
        self._room = room

    def step(self) -> Status | Failure:
        """Look at the words."""
        task: CountTask | DescribeTask = self.get_input("task")
        wanted = task.object
        about_people = isinstance(wanted, ObjectDescription) and wanted.kind == PERSON
        about_everything = wanted is None and task.source is None
        if task.source in self.toolbox.places or (not self._room and (about_people or about_everything)):
            return DONE
        return Failure.postcondition("it is about what is to be seen from here")
