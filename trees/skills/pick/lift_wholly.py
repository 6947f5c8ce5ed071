"""Lift what a hand has taken up, and a cancel stopped on its way: it is picked up when it is lifted."""

from __future__ import annotations

import math

from py_trees.common import Status

from kinematics.requests.move import RetreatRequest
from kinematics.scene.concessions import ConcessionReason, touching
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.planned_motion_leaf import PlannedMotionLeaf
from trees.nodes.ports import ports
from trees.port_values import Target
from trees.readings.held import held_objects
from trees.skills.pick.settings import PickSettings

_STILL_THERE_M = 0.15
"""Nearer than this, horizontally, to where it stood, a thing has not been carried away from there."""


class LiftWholly(PlannedMotionLeaf):
    """Finish the lift of an object that a hand already held, if a cancel has stopped the lift.

    The hand moves straight up as far as the lift still goes, if the object is still above where it was taken.
    An object that was carried away, or that this task has picked up and lifted itself, is not moved.
    """

    INPUT_PORTS = ports(in_hand=bool, target=Target)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the object is an attached body",
        postcondition="it is measured to be as high above where it stood as the policy asks, or was carried "
        "away from there",
        deadline_s=30.0,
        moves="body",
        on_success="the hand goes on holding",
        on_failure="the hand goes on holding",
        on_cancel="the hand goes on holding",
    )

    def goal(self) -> RetreatRequest | None:
        """What is missing of the lift."""
        toolbox, target = self.toolbox, self.get_input("target")
        rise_m = self._rise_m()
        if rise_m is None or rise_m >= toolbox.policy.of(PickSettings).lifted_min_m:
            return None
        held = next(one for one in held_objects(toolbox) if one.name == target.name)
        support = toolbox.world.taken_from[target.name].support
        return RetreatRequest(
            q_start=toolbox.motion.reference(),
            stance=toolbox.motion.stance(),
            scene=toolbox.world.scene,
            hand=held.hand,
            world_offset_m=(0.0, 0.0, toolbox.policy.lift_m - rise_m),
            concessions=touching(
                [target.name], [support], ConcessionReason.SUPPORT_OF_HELD_OBJECT, "retreat"
            ),
        )

    def step(self) -> Status | Failure:
        """Move; it counts as lifted by what is measured."""
        ended = super().step()
        if ended is not DONE:
            return ended
        rise_m, least_m = self._rise_m(), self.toolbox.policy.of(PickSettings).lifted_min_m
        if rise_m is not None and rise_m < least_m:
            name = self.get_input("target").name
            return Failure.postcondition(f"the {name} has not risen enough", needed_m=least_m, lift_m=rise_m)
        return DONE

    def _rise_m(self) -> float | None:
        """How high it is above where it stood; None when it is somewhere else, or that is not known."""
        if not self.get_input("in_hand"):
            return None
        toolbox, name = self.toolbox, self.get_input("target").name
        body = toolbox.world.scene.attached.get(name)
        origin = toolbox.world.taken_from.get(name)
        if body is None or origin is None:
            return None
        odom_T_object = toolbox.model.frame_pose(toolbox.sensing.state().q, body.frame) @ body.frame_T_object
        dx, dy, rise_m = (float(value) for value in (odom_T_object - origin.odom_T_object)[:3, 3])
        return rise_m if math.hypot(dx, dy) <= _STILL_THERE_M else None
