"""Lift what the hand holds away from where it could not be put."""

from __future__ import annotations

from kinematics.requests.move import RetreatRequest
from kinematics.scene.concessions import ConcessionReason, touching
from trees.beliefs.scene.held_object import HeldObject
from trees.nodes.contract import Contract
from trees.nodes.planned_motion_leaf import PlannedMotionLeaf
from trees.nodes.ports import optional, ports
from trees.port_values import Placement

_UP_M = 0.08


class RaiseHeld(PlannedMotionLeaf):
    """Lift the held object straight up by a hand's breadth if it could not be put down at its spot."""

    INPUT_PORTS = ports(held=HeldObject, placement=optional(Placement))
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="none",
        postcondition="the object is clear of its spot, or the hand was not there",
        deadline_s=30.0,
        moves="body",
    )

    def goal(self) -> RetreatRequest | None:
        """Up, unless nothing is held."""
        toolbox, held = self.toolbox, self.get_input("held")
        placement: Placement | None = self.optional("placement")
        if placement is None or held.name not in toolbox.world.scene.attached:
            return None
        reference = toolbox.motion.reference()
        tcp = toolbox.model.frame_pose(reference, toolbox.model.description.tcp_frames[held.hand])
        above_m = float((tcp @ held.tcp_T_object)[2, 3] - placement.odom_T_object[2, 3])
        if above_m > _UP_M:
            return None
        return RetreatRequest(
            q_start=reference,
            stance=toolbox.motion.stance(),
            scene=toolbox.world.scene,
            hand=held.hand,
            world_offset_m=(0.0, 0.0, _UP_M),
            concessions=touching(
                [held.name], placement.touches, ConcessionReason.SUPPORT_OF_HELD_OBJECT, "retreat"
            ),
        )
