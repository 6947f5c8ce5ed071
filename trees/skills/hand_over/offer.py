"""Offer what the hand holds to a person."""

from __future__ import annotations

from kinematics.geometry.planar import PlanarPose
from kinematics.requests.gesture import OfferRequest
from trees.beliefs.grounding.destination import Place
from trees.beliefs.scene.held_object import HeldObject
from trees.failures import Failure, Reason
from trees.nodes.contract import Contract
from trees.nodes.planned_motion_leaf import PlannedMotionLeaf
from trees.nodes.ports import ports
from trees.readings.odometry import feet_pose

_WITHIN_M = 2.5
"""Who stands farther away does not come for what is held out."""


class Offer(PlannedMotionLeaf):
    """Hold the object out, upright, to where the person can take it, and look at the person."""

    INPUT_PORTS = ports(held=HeldObject, place=Place)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the person was seen; the hand holds the object",
        postcondition="every joint is measured to be at the offering posture",
        deadline_s=30.0,
        moves="body",
        on_success="the hand offers the object",
    )

    def goal(self) -> OfferRequest | Failure:
        """Towards the person's axis."""
        toolbox, place = self.toolbox, self.get_input("place")
        if place.category != "person":
            return Failure.infeasible(f"the {place.name} is nobody who could take it")
        away_m = feet_pose(toolbox).distance_m(PlanarPose.of(place.odom_T_place))
        if away_m > _WITHIN_M:
            message = f"{place.name} stands {away_m:.1f} m away"
            return Failure.infeasible(message, person_m=away_m).because(Reason.PERSON_TOO_FAR)
        x, y, z = (float(value) for value in place.aim_m)
        return OfferRequest(
            q_start=toolbox.motion.reference(),
            stance=toolbox.motion.stance(),
            scene=toolbox.world.scene,
            held=self.get_input("held").name,
            person_m=(x, y, z),
            seed=int(toolbox.rng.integers(2**31)),
        )
