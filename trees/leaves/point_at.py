"""Point at something."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from py_trees.common import Status

from kinematics.gesture_requests import PointRequest
from kinematics.pointing import pointing_error_m
from kinematics.robot_description import HANDS, Hand
from trees.contract import Contract
from trees.destination import Place
from trees.failures import Failure
from trees.free_hand import free_hands
from trees.leaf import DONE
from trees.planned_motion_leaf import PlannedMotionLeaf
from trees.ports import ports
from trees.tasks import PointAtTask


class PointAt(PlannedMotionLeaf):
    """Stretch a free arm towards what is meant, and measure where it points."""

    INPUT_PORTS = ports(task=PointAtTask, place=Place)
    OUTPUT_PORTS = ports(evidence=dict)
    CONTRACT = Contract(
        precondition="what is meant was seen; a hand is free",
        postcondition="the line through forearm and hand, as the encoders have it, passes the target nearer "
        "than the policy's tolerance",
        deadline_s=30.0,
        moves="body",
        on_success="the arm points",
    )

    def goal(self) -> PointRequest | Failure:
        """Point with any free hand; the planner takes the nearer one first."""
        free = free_hands(self.toolbox, self.get_input("task").hand)
        if isinstance(free, Failure):
            return free
        x, y, z = (float(value) for value in self.get_input("place").aim_m)
        return PointRequest(
            q_start=self.toolbox.motion.reference(),
            stance=self.toolbox.motion.stance(),
            scene=self.toolbox.world.scene,
            target_m=(x, y, z),
            hands=free,
            seed=int(self.toolbox.rng.integers(2**31)),
        )

    def step(self) -> Status | Failure:
        """Move, then measure."""
        outcome = super().step()
        if outcome is not DONE:
            return outcome
        hand, off_m = self._best_hand(self.get_input("place").aim_m)
        self.measured(hand=hand, off_m=off_m)
        tolerance = self.toolbox.policy.pointing_tolerance_m
        if off_m > tolerance:
            return Failure.postcondition("the arm points beside it", off_m=off_m, tolerance_m=tolerance)
        self._set_output("evidence", {"hand": hand, "off_m": off_m})
        return DONE

    def _best_hand(self, aim: NDArray[np.float64]) -> tuple[Hand, float]:
        model, q = self.toolbox.model, self.toolbox.sensing.state().q
        errors = {hand: pointing_error_m(model, q, hand, aim) for hand in HANDS}
        hand = min(HANDS, key=lambda one: errors[one])
        return hand, errors[hand]
