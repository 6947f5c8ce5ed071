"""Open the hand on an object that stands."""

from __future__ import annotations

from collections.abc import Mapping

from py_trees.common import Status

from kinematics.model.palm_grip import released
from robots.control.motion_handle import MotionHandle
from trees.beliefs.scene.held_object import HeldObject
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, RUNNING
from trees.nodes.motion_leaf import MotionLeaf
from trees.nodes.ports import ports
from trees.toolbox import Toolbox

# The pads' zero and the encoder's noise leave the last tenth uncertain.
_OPEN_SHARE = 0.9


class LetGo(MotionLeaf):
    """Open the hand, and let the planning scene have the object where the hand has it.

    It fails, and the hand stays closed, when the object was not felt to stand on something; made with
    ``anyway``, it opens all the same.
    """

    INPUT_PORTS = ports(held=HeldObject, touched=bool)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="something carries the object",
        postcondition="the gripper measures nine tenths of its largest opening or more; the object is "
        "part of the world again",
        deadline_s=4.0,
        moves="gripper",
        on_success="the gripper is open",
        on_failure="the gripper holds its present opening",
        on_cancel="the gripper holds its present opening",
    )

    def __init__(
        self,
        name: str,
        toolbox: Toolbox,
        anyway: bool = False,
        wiring: Mapping[str, str] | None = None,
    ) -> None:
        super().__init__(name, toolbox, wiring)
        self._anyway = anyway

    def start(self) -> MotionHandle | Failure:
        """Open, if nothing will fall."""
        held: HeldObject = self.get_input("held")
        if not self._anyway and not self.get_input("touched"):
            return Failure.postcondition(f"nothing is felt under the {held.name}; it is kept")
        return self.toolbox.grippers[held.hand].open()

    def finish(self) -> Status | Failure:
        """Measure the opening; ``RUNNING`` until it is wide enough, the deadline ends that."""
        held: HeldObject = self.get_input("held")
        gripper = self.toolbox.model.description.grippers[held.hand]
        opening_m = self.toolbox.grippers[held.hand].reading().opening_m
        if opening_m < _OPEN_SHARE * gripper.max_opening_m:
            return RUNNING
        world, model = self.toolbox.world, self.toolbox.model
        if held.name in world.scene.attached:
            tcp = model.frame_pose(self.toolbox.sensing.state().q, gripper.tcp_frame)
            world.update(
                world.scene.with_detached(held.name, tcp @ released(gripper, held.shape, held.tcp_T_object))
            )
            world.note_put_down(held.name)
        self.feedback_message = f"{opening_m * 1000:.0f} mm open"
        return DONE
