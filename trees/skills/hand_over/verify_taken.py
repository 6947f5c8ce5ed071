"""See that the person has it, and not somebody else."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
from py_trees.common import Status

from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Ball
from kinematics.scene.planning_scene import PlanningScene
from kinematics.scene.support_of import support_of
from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.grounding.destination import Place
from trees.beliefs.scene.believed_thing import PERSON
from trees.beliefs.scene.held_object import HeldObject
from trees.beliefs.scene.scene_update import kind_of
from trees.failures import Failure, Reason
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.port_values import Placement
from trees.skills.looking.look_around import LookAround

# Lower than this above the floor, and nobody holds it.
_DROPPED_BELOW_M = 0.4
# Nearer than this to the empty hand, it lies on the fingers.
_ON_THE_HAND_M = 0.10
# What stands upright so far beside where it was let go did not fall there.
_CARRIED_M = 0.25


class VerifyTaken(LookAround):
    """See that the person has taken the object.

    It has been taken when it is seen in the air and away from the hand, since nothing hangs in the air by
    itself, or when it stands far from where the hand let go of it. It must also have gone towards the person
    that it was meant for, since somebody else may have taken it. It has not been taken when it was dropped,
    or is still at the hand.
    """

    INPUT_PORTS = ports(stood=dict, held=HeldObject, place=Place, placement=Placement)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the hand was opened while the person pulled, and drawn back since",
        postcondition="the object was seen where only that person carries it, or has; the gripper is empty",
        deadline_s=2.0,
    )

    def found(self, seen: Mapping[str, ObjectEstimate]) -> Status | Failure:
        """Where is it?"""
        held, model = self.get_input("held"), self.toolbox.model
        policy, scene, stood = self.toolbox.policy, self.toolbox.world.scene, self.get_input("stood")
        if self.toolbox.grippers[held.hand].reading().holding:
            return Failure.postcondition(f"the {held.hand} hand still holds the {held.name}")
        person = self.get_input("place").name
        q = self.toolbox.sensing.state().q
        tcp = model.frame_pose(q, model.description.tcp_frames[held.hand])[:3, 3]
        for name, item in seen.items():
            if name in stood or not item.may_be(held.kind, held.color):
                continue  # in the first case another one, that was there all the time
            from_hand_m = float(np.linalg.norm(item.odom_T_object[:3, 3] - tcp))
            height_m = float(item.odom_T_object[2, 3])
            self.measured(height_m=height_m, from_hand_m=from_hand_m)
            if from_hand_m < _ON_THE_HAND_M:
                return Failure.postcondition(f"the {held.name} is still at the {held.hand} hand")
            stands_on = support_of(scene.objects[name], scene, policy.support_gap_m)
            if (stands_on is not None and not self._carried(item)) or height_m < _DROPPED_BELOW_M:
                where = "" if stands_on is None else f" onto the {stands_on.name}"
                message = f"the {held.name} was dropped{where}"
                return Failure.postcondition(message, height_m=height_m).because(Reason.DROPPED)
            let_go = self.get_input("placement").odom_T_object
            if (other := another_took_it(person, let_go, item.odom_T_object, scene)) is not None:
                message = f"the {held.name} was taken by {other}, not by {person}"
                return Failure.postcondition(message, height_m=height_m).because(Reason.TAKEN_BY_ANOTHER)
            self.feedback_message = f"seen {height_m:.2f} m above the floor"
            return DONE
        return Failure.postcondition(f"the {held.name} was let go, and is not seen with {person}")

    def _carried(self, item: ObjectEstimate) -> bool:
        """Whether it stands where it cannot have fallen."""
        let_go = self.get_input("placement").odom_T_object[:2, 3]
        far = float(np.hypot(*(item.odom_T_object[:2, 3] - let_go))) >= _CARRIED_M
        return far and not item.lying and not isinstance(item.shape, Ball)


_CLEARLY_M = 0.05
"""Who is in nearly the same direction may be the one whom it was meant for."""


def another_took_it(addressed: str, let_go: Transform, now: Transform, scene: PlanningScene) -> str | None:
    """Name of somebody towards whom a thing went, if not towards whom it was meant for.

    Args:
        addressed: Whom it was meant for, by the name in the planning scene.
        let_go, now: Where the thing was let go and where it was seen since, odometry frame, shape (4, 4).
        scene: What is believed.
    """
    nearer_m = {
        name: _apart_m(let_go, item.world_T_object) - _apart_m(now, item.world_T_object)
        for name, item in scene.objects.items()
        if kind_of(name) == PERSON or name[:1].isupper()
    }
    taker = max(nearer_m, key=lambda name: (nearer_m[name], name), default=addressed)
    if addressed not in nearer_m or nearer_m[taker] < nearer_m[addressed] + _CLEARLY_M:
        return None
    return taker


def _apart_m(one: Transform, other: Transform) -> float:
    """Along the floor."""
    return math.dist(one[:2, 3].tolist(), other[:2, 3].tolist())
