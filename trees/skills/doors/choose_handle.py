"""Choose the door or drawer that a task means, once those beside it were seen as well."""

from __future__ import annotations

from collections.abc import Mapping

from py_trees.common import Status

from trees.beliefs.openings.handles import HandleTarget
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports
from trees.readings.odometry import feet_pose
from trees.skills.doors.meant_part import meant_part, those_meant_here
from trees.skills.doors.pushed_front import known_parts
from trees.tasks import CloseTask, ObjectDescription, OpenTask
from trees.toolbox import Toolbox


class ChooseHandle(Leaf):
    """Choose the door or drawer that the task means among all that were seen.

    A look may have shown only one of several; "the right fridge" can be told only once all have been seen.
    """

    ASKS = True
    INPUT_PORTS = ports(task=object, seen=HandleTarget)
    OUTPUT_PORTS = ports(handle=HandleTarget)
    CONTRACT = Contract(
        precondition="a handle of the kind was seen, and what is beside it looked at",
        postcondition="the handle is the one that the task means, of all that were seen",
        deadline_s=1.0,
    )

    def __init__(
        self, name: str, toolbox: Toolbox, *, pushed: bool, wiring: Mapping[str, str] | None = None
    ) -> None:
        """Make the leaf.

        Args:
            name: Its name.
            toolbox: What it may call.
            pushed: Whether a door's front is enough, without its handle.
            wiring: Other names of its ports.
        """
        super().__init__(name, toolbox, {"seen": "handle", **(wiring or {})})
        self._pushed = pushed

    def step(self) -> Status | Failure:
        """An answer has chosen already."""
        task: OpenTask | CloseTask = self.get_input("task")
        wanted, first = task.object, self.get_input("seen")
        named = isinstance(wanted, ObjectDescription) and wanted.name is not None
        drawers = self.toolbox.model.description.pushing.drawers
        known = known_parts(self.toolbox.world.scene, feet_pose(self.toolbox), self._pushed, drawers)
        fitting = those_meant_here(task, known, self.toolbox)
        chosen = first if named or not fitting else meant_part(task, fitting, self.toolbox)
        if isinstance(chosen, Failure):
            return chosen
        self._set_output("handle", chosen)
        self.feedback_message = f"{chosen.part}, of {len(fitting)}"
        return DONE
