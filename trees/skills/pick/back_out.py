"""Take the hand back from the object."""

from __future__ import annotations

import numpy as np

from kinematics.requests.grasp import Grasp
from kinematics.requests.move import RetreatRequest
from trees.nodes.contract import Contract
from trees.nodes.planned_motion_leaf import PlannedMotionLeaf
from trees.nodes.ports import optional, ports
from trees.port_values import Step, Target

# Less than this into the approach is no approach; more than this beside it is not on its line.
_BEGUN_M = 0.01
_BESIDE_M = 0.03


class BackOut(PlannedMotionLeaf):
    """Move the hand straight back along the approach that it has begun, to the pre-grasp pose.

    The target is left out of the scene for this motion: it is no longer where it was believed to be, and the
    hand goes back the way it came.
    """

    INPUT_PORTS = ports(grasp=optional(Grasp), approach=optional(Step), target=optional(Target))
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the hand is open",
        postcondition="the hand is at the pre-grasp pose, or was not on the approach",
        deadline_s=30.0,
        moves="body",
    )

    def goal(self) -> RetreatRequest | None:
        """Back by as much as the hand has gone in."""
        grasp, approach = self.optional("grasp"), self.optional("approach")
        target: Target | None = self.optional("target")
        if grasp is None or approach is None:
            return None
        toolbox = self.toolbox
        frame = toolbox.model.description.grippers[grasp.hand].tcp_frame
        reference = toolbox.motion.reference()
        ahead = grasp.world_T_tcp[:3, 0]
        past = toolbox.model.frame_pose(reference, frame)[:3, 3] - grasp.world_T_tcp[:3, 3]
        gone_in_m = grasp.approach_m + float(past @ ahead)
        beside_m = float(np.linalg.norm(past - (past @ ahead) * ahead))
        if gone_in_m < _BEGUN_M or beside_m > _BESIDE_M:
            return None
        scene = toolbox.world.scene
        if target is not None and target.name in scene.objects:
            scene = scene.without_object(target.name)
        x, y, z = (float(value) for value in -gone_in_m * ahead)
        return RetreatRequest(
            q_start=reference,
            stance=toolbox.motion.stance(),
            scene=scene,
            hand=grasp.hand,
            world_offset_m=(x, y, z),
            concessions=approach.concessions,
        )
