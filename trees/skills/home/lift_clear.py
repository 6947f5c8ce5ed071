"""Lift what a hand holds off what it stands on, before anything else moves."""

from __future__ import annotations

from dataclasses import replace

from kinematics.model.robot_description import Hand
from kinematics.requests.move import RetreatRequest
from kinematics.scene.concessions import ConcessionReason, touching
from kinematics.scene.support_of import lowest_point_m, supports_of, top_m
from trees.nodes.contract import Contract
from trees.nodes.planned_motion_leaf import PlannedMotionLeaf
from trees.nodes.ports import ports
from trees.toolbox import Toolbox

_NEAR_M = 0.02
"""What is held nearer than this above furniture stands on it, or would break its margin at the start."""
_UP_M = 0.05


class LiftClear(PlannedMotionLeaf):
    """Lift a held object straight up, if it stands on furniture or is just above it.

    A cancelled task may have left it there. Any other motion from there would begin in contact, and so cannot
    be planned. The same holds for a hand that feels something between its fingers that is not in the planning
    scene.
    """

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="none",
        postcondition="nothing that a hand holds is near what could carry it",
        deadline_s=30.0,
        moves="body",
    )

    def goal(self) -> RetreatRequest | None:
        """Up, unless nothing is held, or nothing is under it."""
        toolbox = self.toolbox
        found = held_near_support(toolbox)
        if found is None and (unknown := felt_and_not_known(toolbox)) is not None:
            found = unknown, []
        if found is None:
            return None
        hand, pairs = found
        return RetreatRequest(
            q_start=toolbox.motion.reference(),
            stance=toolbox.motion.stance(),
            scene=toolbox.world.scene,
            hand=hand,
            world_offset_m=(0.0, 0.0, _UP_M),
            concessions=tuple(
                one
                for pair in pairs
                for one in touching(pair[:1], pair[1:], ConcessionReason.SUPPORT_OF_HELD_OBJECT, "retreat")
            ),
        )


def felt_and_not_known(toolbox: Toolbox) -> Hand | None:
    """A hand that feels something between its fingers of which nothing is known; else None.

    Whoever took over a robot knows of nothing that it holds, and fingers may hide it from the eyes.
    """
    frames = toolbox.model.description.tcp_frames
    known = {body.frame for body in toolbox.world.scene.attached.values()}
    hands = (hand for hand in toolbox.grippers if frames[hand] not in known)
    return next((hand for hand in hands if toolbox.grippers[hand].reading().holding), None)


def held_near_support(toolbox: Toolbox) -> tuple[Hand, list[tuple[str, str]]] | None:
    """The hand whose object is on furniture or just above it, and the pairs that touch there; else None."""
    scene, model = toolbox.world.scene, toolbox.model
    if not scene.attached:
        return None
    q = toolbox.motion.reference()
    for hand in model.description.hands:
        frame = model.description.tcp_frames.get(hand)
        for name, body in sorted(scene.attached.items()):
            if body.frame != frame:
                continue
            pose = model.frame_pose(q, body.frame) @ body.frame_T_object
            item = replace(body.body, world_T_object=pose)
            under = [
                other
                for other in supports_of(item, scene)
                if lowest_point_m(item) - top_m(scene.objects[other]) < _NEAR_M
            ]
            if under:
                return hand, [(min(name, other), max(name, other)) for other in under]
    return None
