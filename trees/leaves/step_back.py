"""Draw the open hand back from a handle."""

from __future__ import annotations

import numpy as np

from kinematics.requests import Grasp, RetreatRequest
from trees.contract import Contract
from trees.handles import HandleTarget
from trees.held_handle import scene_of_hand, tcp_m
from trees.planned_motion_leaf import PlannedMotionLeaf
from trees.ports import optional, ports

_BACK_M = 0.10
_NEAR_M = 0.08


class StepBack(PlannedMotionLeaf):
    """Move the hand straight back along its own approach, clear of the handle."""

    INPUT_PORTS = ports(handle=optional(HandleTarget), grasp=optional(Grasp))
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the gripper is open",
        postcondition="the hand is clear of the handle, at rest",
        deadline_s=20.0,
        moves="body",
        on_success="the hand is before the handle",
    )

    def goal(self) -> RetreatRequest | None:
        """A straight line against the TCP's x axis; None where the hand is not about the handle."""
        toolbox, target = self.toolbox, self.optional("handle")
        grasp: Grasp | None = self.optional("grasp")
        if grasp is None or target is None or target.handle not in toolbox.world.scene.objects:
            return None
        frame = toolbox.model.description.grippers[grasp.hand].tcp_frame
        q = toolbox.motion.reference()
        bar_m = toolbox.world.scene.objects[target.handle].world_T_object[:3, 3]
        if float(np.linalg.norm(tcp_m(toolbox, grasp, q) - bar_m)) > _NEAR_M:
            return None
        x, y, z = (float(value) for value in -_BACK_M * toolbox.model.frame_pose(q, frame)[:3, 0])
        return RetreatRequest(
            q_start=q,
            stance=toolbox.motion.stance(),
            scene=scene_of_hand(toolbox, target, grasp),
            hand=grasp.hand,
            world_offset_m=(x, y, z),
        )
