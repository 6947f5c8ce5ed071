"""See that the object stands where it was put."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
from py_trees.common import Status

from kinematics.arrays import Array
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Shape
from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.scene.bystanders import disturbed
from trees.beliefs.scene.held_object import HeldObject
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.port_values import Placement
from trees.skills.looking.look_around import LookAround
from trees.toolbox import Toolbox

# A perceived lean below this is noise.
_UPRIGHT_RAD = math.radians(15.0)


class VerifyPlaced(LookAround):
    """See that the object stands upright near the spot where it was put.

    Attributes:
        tolerance_m: How far from the spot it may be, in metres.
    """

    INPUT_PORTS = ports(stood=dict, held=HeldObject, placement=Placement)
    OUTPUT_PORTS = ports(evidence=dict)
    CONTRACT = Contract(
        precondition="the hand is clear of the object, the head at rest",
        postcondition="the object was seen within the tolerance of its placement, upright, and the "
        "hand holds nothing; nothing else was moved",
        deadline_s=2.0,
    )

    def __init__(self, name: str, toolbox: Toolbox, tolerance_m: float) -> None:
        super().__init__(name, toolbox)
        self.tolerance_m = tolerance_m

    def found(self, seen: Mapping[str, ObjectEstimate]) -> Status | Failure:
        """Compare what was seen with what was meant."""
        held, placement, stood = self.get_input("held"), self.get_input("placement"), self.get_input("stood")
        place = _foot(placement.odom_T_object, held.shape)
        same = [
            item for name, item in seen.items() if item.may_be(held.kind, held.color) and name not in stood
        ]
        if not same:
            return Failure.postcondition(f"the {held.name} is not seen where it was put", frames=len(seen))
        away_m = [float(np.linalg.norm(_foot(item.odom_T_object, item.shape) - place)) for item in same]
        off_m = min(away_m)
        nearest = same[away_m.index(off_m)]
        numbers = {"off_m": off_m, "tilt_rad": nearest.tilt_rad}
        self.measured(**numbers)
        if off_m > self.tolerance_m:
            return Failure.postcondition(f"the {held.name} is not where it was put", None, **numbers)
        if nearest.lying or nearest.tilt_rad > _UPRIGHT_RAD:
            return Failure.postcondition(f"the {held.name} has fallen over", None, **numbers)
        policy, scene = self.toolbox.policy, self.toolbox.world.scene
        harm = disturbed(stood, scene, policy.undisturbed_m)
        if harm is not None:
            return harm
        on = placement.touches[0] if placement.touches else ""
        self._set_output("evidence", {"object": held.name, "on": on, "hand": held.hand, **numbers})
        self.feedback_message = f"{off_m * 1000:.0f} mm from where it was meant to stand"
        return DONE


def _foot(odom_T_object: Transform, shape: Shape) -> Array:
    """The lowest point on the axis of what stands: the picture's edge may cut its top off.

    Of what lies the place is far enough off either way.
    """
    foot: Array = odom_T_object[:3, 3] - np.array([0.0, 0.0, 0.5 * shape.height_m])
    return foot
