"""Lower what the hand holds to where it was lifted from."""

from __future__ import annotations

from kinematics.requests.grasp import Grasp
from kinematics.requests.move import RetreatRequest
from trees.nodes.contract import Contract
from trees.nodes.planned_motion_leaf import PlannedMotionLeaf
from trees.nodes.ports import optional, ports
from trees.port_values import Step

# Let go this far above the support: a perception bias must not press the object into it.
_DROP_M = 0.004


class PutBack(PlannedMotionLeaf):
    """Lower a held object straight down to where it was grasped; without one nothing moves."""

    INPUT_PORTS = ports(grasp=optional(Grasp), held_lift=optional(Step))
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="none",
        postcondition="the hand is at the height at which it grasped the object, or holds nothing",
        deadline_s=30.0,
        moves="body",
    )

    def goal(self) -> RetreatRequest | None:
        """Straight down by what it is above the grasp."""
        toolbox = self.toolbox
        grasp, lift = self.optional("grasp"), self.optional("held_lift")
        if grasp is None or lift is None or not toolbox.world.scene.attached:
            return None
        drop_m = height_above_grasp_m(self, grasp) - _DROP_M
        if drop_m <= _DROP_M or not toolbox.grippers[grasp.hand].reading().holding:
            return None
        return RetreatRequest(
            q_start=toolbox.motion.reference(),
            stance=toolbox.motion.stance(),
            scene=toolbox.world.scene,
            hand=grasp.hand,
            world_offset_m=(0.0, 0.0, -drop_m),
            concessions=lift.concessions,
        )


def height_above_grasp_m(leaf: PlannedMotionLeaf, grasp: Grasp) -> float:
    """How far the commanded TCP is above the pose of a grasp."""
    model = leaf.toolbox.model
    tcp = model.frame_pose(leaf.toolbox.motion.reference(), model.description.grippers[grasp.hand].tcp_frame)
    return float(tcp[2, 3] - grasp.world_T_tcp[2, 3])
