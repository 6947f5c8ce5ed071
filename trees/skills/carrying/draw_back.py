"""Draw an open hand back from what it held."""

from __future__ import annotations

from kinematics.requests.move import RetreatRequest
from kinematics.scene.concessions import ConcessionReason, touching
from trees.beliefs.scene.held_object import HeldObject
from trees.nodes.contract import Contract
from trees.nodes.planned_motion_leaf import PlannedMotionLeaf
from trees.nodes.ports import ports

_SHARES = (1.0, 0.7, 0.4)
"""Of the whole way; a short one is better than none."""


class DrawBack(PlannedMotionLeaf):
    """Draw the open hand straight back along its own axis, until it is clear of what it held."""

    INPUT_PORTS = ports(held=HeldObject)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the hand is open",
        postcondition="every joint is measured to be where the hand is clear of the object",
        deadline_s=30.0,
        moves="body",
    )

    def goal(self) -> RetreatRequest:
        """The fingers may touch what they held; everything else keeps its distance."""
        toolbox, held = self.toolbox, self.get_input("held")
        gripper = toolbox.model.description.grippers[held.hand]
        reference = toolbox.motion.reference()
        back = -toolbox.policy.retreat_m * toolbox.model.frame_pose(reference, gripper.tcp_frame)[:3, 0]
        x, y, z = (float(value) for value in back)
        return RetreatRequest(
            q_start=reference,
            stance=toolbox.motion.stance(),
            scene=toolbox.world.scene,
            hand=held.hand,
            world_offset_m=(x, y, z),
            shares=_SHARES,
            concessions=touching(
                sorted(gripper.touch_links), [held.name], ConcessionReason.GRASPED_OBJECT, "retreat"
            ),
        )
