"""Recall where a door or drawer was seen that cannot be looked at well from here."""

from __future__ import annotations

import math
from collections.abc import Mapping

from py_trees.common import Status

from trees.beliefs.openings.handles import HandleTarget
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports
from trees.readings.odometry import feet_pose
from trees.skills.doors.handle_standing import handle_standing_place
from trees.skills.doors.meant_part import meant_part, noun_of, those_meant_here
from trees.skills.doors.pushed_front import known_parts
from trees.tasks import CloseTask, OpenTask
from trees.toolbox import Toolbox

_FAR_M = 1.0
"""From so far beside the place for it on, whether it is seen depends on where the robot happens to stand."""


class RecallHandle(Leaf):
    """Take the door or drawer that the task names from the world model, to go there and look again.

    It is for what cannot be seen well from here: a wide-open door, for example, is seen edge-on by who stands
    before the furniture that it belongs to.
    """

    ASKS = True
    INPUT_PORTS = ports(task=object)
    OUTPUT_PORTS = ports(handle=HandleTarget)
    CONTRACT = Contract(
        precondition="none",
        postcondition="the one handle that fits, where it was last seen: far from the robot, or behind it",
        deadline_s=1.0,
    )

    def __init__(
        self, name: str, toolbox: Toolbox, pushed: bool, wiring: Mapping[str, str] | None = None
    ) -> None:
        """Make the leaf.

        Args:
            name: Its name.
            toolbox: What it may call.
            pushed: Whether a door's front is enough, without its handle.
            wiring: Other names of its ports.
        """
        super().__init__(name, toolbox, wiring)
        self._pushed = pushed

    def step(self) -> Status | Failure:
        """Look it up."""
        toolbox = self.toolbox
        task: OpenTask | CloseTask = self.get_input("task")
        noun = noun_of(task)
        body = feet_pose(toolbox)
        drawers = toolbox.model.description.pushing.drawers
        targets = known_parts(toolbox.world.scene, body, self._pushed, drawers)
        fitting = those_meant_here(task, targets, toolbox)
        if not fitting:
            return Failure.postcondition(f"no {noun or 'door or drawer'} was seen before")
        chosen = meant_part(task, fitting, toolbox)
        if isinstance(chosen, Failure):
            return Failure.postcondition(f"which {noun} was meant has to be seen")
        place = body.to(handle_standing_place(chosen, body, toolbox.model.description))
        away_m = math.hypot(place.x_m, place.y_m)
        # Right before an open drawer there is no room for the feet to turn to what is beside the robot.
        if away_m < _FAR_M and abs(place.yaw_rad) < toolbox.policy.beside_rad:
            return Failure.postcondition("it is near enough to be looked at from here", away_m=away_m)
        self._set_output("handle", chosen)
        self.feedback_message = f"{chosen.part} where it was seen"
        return DONE
