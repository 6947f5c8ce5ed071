"""Measure where the arms point."""

from __future__ import annotations

from py_trees.common import Status

from kinematics.ik.arm_frames import pointing_error_m
from trees.beliefs.grounding.destination import Place
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports
from trees.skills.gestures.settings import GestureSettings


class VerifyPointing(Leaf):
    """Measure with the encoders that the line through a forearm and its hand meets what is meant."""

    INPUT_PORTS = ports(place=Place)
    OUTPUT_PORTS = ports(evidence=dict)
    CONTRACT = Contract(
        precondition="an arm was stretched towards what is meant",
        postcondition="the line through a forearm and its hand, as the encoders have it, passes what is "
        "meant nearer than the policy's tolerance",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """The arm that points better counts."""
        toolbox, aim = self.toolbox, self.get_input("place").aim_m
        q = toolbox.sensing.state().q
        hands = toolbox.model.description.hands
        errors_m = {hand: pointing_error_m(toolbox.model, q, hand, aim) for hand in hands}
        hand = min(errors_m, key=lambda one: errors_m[one])
        off_m, tolerance_m = errors_m[hand], toolbox.policy.of(GestureSettings).pointing_tolerance_m
        self.measured(hand=hand, off_m=off_m)
        if off_m > tolerance_m:
            return Failure.postcondition("the arm points beside it", off_m=off_m, tolerance_m=tolerance_m)
        self._set_output("evidence", {"hand": hand, "off_m": off_m})
        return DONE
