"""Let a person have what the hand holds."""

from __future__ import annotations

from py_trees.common import Status

from robots.control.motion_handle import MotionHandle
from trees.beliefs.scene.held_object import HeldObject
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, RUNNING
from trees.nodes.motion_leaf import MotionLeaf
from trees.nodes.ports import ports
from trees.port_values import Placement

_OPEN_SHARE = 0.9


class Give(MotionLeaf):
    """Open the hand; the person has the object now, and it is no longer part of the planning scene."""

    INPUT_PORTS = ports(held=HeldObject, pull_n=float)
    OUTPUT_PORTS = ports(evidence=dict, placement=Placement)
    CONTRACT = Contract(
        precondition="the person pulls at the object",
        postcondition="the gripper measures nine tenths of its largest opening or more; where the object was "
        "let go is written",
        deadline_s=4.0,
        moves="gripper",
        on_success="the gripper is open",
        on_failure="the gripper holds its present opening",
        on_cancel="the gripper holds its present opening",
    )

    def start(self) -> MotionHandle:
        """Open."""
        return self.toolbox.grippers[self.get_input("held").hand].open()

    def finish(self) -> Status | Failure:
        """Measure the opening; ``RUNNING`` until it is wide enough, the deadline ends that."""
        held: HeldObject = self.get_input("held")
        gripper = self.toolbox.model.description.grippers[held.hand]
        opening_m = self.toolbox.grippers[held.hand].reading().opening_m
        if opening_m < _OPEN_SHARE * gripper.max_opening_m:
            return RUNNING
        world, model = self.toolbox.world, self.toolbox.model
        tcp = model.frame_pose(self.toolbox.sensing.state().q, model.description.tcp_frames[held.hand])
        offered = tcp @ held.tcp_T_object
        if held.name in world.scene.attached:
            world.update(world.scene.with_detached(held.name, offered).without_object(held.name))
        x, y = (float(value) for value in offered[:2, 3])
        self._set_output("placement", Placement(held.hand, offered, (), (x, y)))
        pull_n = self.get_input("pull_n")
        self._set_output("evidence", {"given": held.name, "hand": held.hand, "pull_n": pull_n})
        return DONE
