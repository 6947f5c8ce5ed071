"""Tell whether a question is about more than what stands in front of the robot."""

from __future__ import annotations

from py_trees.common import Status

from trees.beliefs.scene.believed_thing import PERSON
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports
from trees.tasks import CountTask, DescribeTask, FindTask, ObjectDescription
from trees.toolbox import Toolbox


class AsksFarther(Leaf):
    """Succeed if the question is about people, a room, or things that may be far from the robot."""

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
        task: CountTask | DescribeTask | FindTask = self.get_input("task")
        wanted = task.person if isinstance(task, FindTask) and task.person else task.object
        about_people = isinstance(wanted, ObjectDescription) and wanted.kind == PERSON
        anywhere = task.source is None and (wanted is None or isinstance(task, FindTask))
        if task.source in self.toolbox.places or (not self._room and (about_people or anywhere)):
            return DONE
        if isinstance(task, FindTask) and anywhere and self.toolbox.places:
            return DONE  # all that is to be found may be anywhere in the rooms
        return Failure.postcondition("it is about what is to be seen from here")
