"""Raise a hand to wave."""

from __future__ import annotations

from kinematics.model.robot_description import Hand
from kinematics.requests.gesture import RaiseHandRequest
from trees.beliefs.grounding.destination import Place
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.planned_motion_leaf import PlannedMotionLeaf
from trees.nodes.ports import ports
from trees.readings.held import free_hands
from trees.readings.odometry import bearing_rad


class RaiseHand(PlannedMotionLeaf):
    """Turn the trunk to the person, and raise a free hand beside the head."""

    INPUT_PORTS = ports(task=object, place=Place)
    OUTPUT_PORTS = ports(waving_hand=str)
    CONTRACT = Contract(
        precondition="the person was seen; a hand is free",
        postcondition="every joint is measured to be at the raised posture, which faces the person",
        deadline_s=30.0,
        moves="body",
        on_success="the hand is raised and still",
    )

    def goal(self) -> RaiseHandRequest | Failure:
        """The named hand, else the free one on the person's side: it need not cross the body."""
        place: Place = self.get_input("place")
        free = free_hands(self.toolbox, getattr(self.get_input("task"), "hand", None))
        if isinstance(free, Failure):
            return free
        nearer: Hand = "left" if bearing_rad(self.toolbox, place) > 0.0 else "right"
        hand = nearer if nearer in free else free[0]
        self._set_output("waving_hand", hand)
        x, y, z = (float(value) for value in place.aim_m)
        return RaiseHandRequest(
            q_start=self.toolbox.motion.reference(),
            stance=self.toolbox.motion.stance(),
            scene=self.toolbox.world.scene,
            hand=hand,
            towards_m=(x, y, z),
            seed=int(self.toolbox.rng.integers(2**31)),
        )
